%
O0001
(rule: F 3.5 R below 0: more than half a turn; R wins over I and J; R and end = start: no motion)
(expect: to X10 Y10 cw I10 J0)
(expect: to X0 Y0)
(expect: to X10 Y10 cw I0 J10)
(expect: to X0 Y0)
(expect: to X10 Y10 cw I10 J0)
G02X10.Y10.R10.F100
G00X0Y0
G02X10.Y10.R-10.
G00X0Y0
G02X10.Y10.R10.I99.J5.
G02X10.Y10.R10.
M30
%
