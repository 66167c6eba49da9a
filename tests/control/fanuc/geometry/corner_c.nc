%
O0001
(rule: F 3.8 C is the distance from the corner)
(expect: to X0 Y0)
(expect: to X38 Y0 line F200)
(expect: to X40 Y2 line F200)
(expect: to X40 Y30 line F100)
S1000M03
G90G00X0Y0
G01X40.,C2.F200.
Y30.F100.
M30
%
