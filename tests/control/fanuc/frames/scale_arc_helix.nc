%
O0001
(rule: F 3.7 a helix by its centre under unequal factors is not executed)
(expect: to X0 Y10)
(expect: alarm  K5229 at 8:1)
G51X0Y0Z0I2000J1000K1000
G00X0Y10.S500M3
G02X10.Y0J-10.Z-5.F100
M30
%
