%
O0001
(rule: F 3.8 between a line and an arc)
(expect: to X0 Y0)
(expect: to X5.5051 Y0)
(expect: to X10.4041 Y4 ccw I5.5051 J5)
(expect: to X30 Y20 cw I30 J0)
S1000M03
G90G00X0Y0
G01X10. , R 5. F200.
G02X30.Y20.I20.J0
M30
%
