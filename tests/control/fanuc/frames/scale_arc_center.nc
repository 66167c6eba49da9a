%
O0001
(rule: F 3.7 an arc by its centre under unequal factors: about the scaled centre to the direction of its end, then a line)
(expect: to X0 Y10)
(expect: to X10 Y0 cw I0 J0 F100)
(expect: to X20 Y0 line F100)
(expect: to X0 Y-20 cw I0 J0 F100)
(expect: to X0 Y-10 line F100)
G51X0Y0Z0I2000J1000K1000
G00X0Y10.S500M3
G02X10.Y0J-10.F100
G02X0Y-10.I-10.J0
M30
%
