%
O0001
(rule: F 3.7 a factor below 0 mirrors: the arc turns round)
(expect: to X0 Y10)
(expect: to X-10 Y0 ccw I0 J0 F100)
(expect: to X-20 Y0 line F100)
G51X0Y0Z0I-2000J1000K1000
G00X0Y10.S500M3
G02X10.Y0J-10.F100
M30
%
