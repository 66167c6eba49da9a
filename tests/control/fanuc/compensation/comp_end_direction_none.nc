%
O0001
(rule: F 4.3 G40 I J: where both ways do not meet, on the normal)
(expect: to X0 Y20)
(expect: to X0 Y5)
(expect: to X40 Y5)
(expect: to X60 Y40)
G10L12P1R5.
G17G90G40
M3S1000
G00X0.Y20.
G41D1G01X0.Y0.F200.
X40.
G40X60.Y40.I1.J0.
M30
%
