%
O0001
(rule: F 3.7 an arc by radius under unequal factors: the radius by the larger one)
(expect: to X0 Y10)
(expect: to X20 Y0 cw I2.583802 J-9.832397 F100)
G51X0Y0Z0I2000J1000K1000
G00X0Y10.S500M3
G02X10.Y0R10.F100
G50
M30
%
