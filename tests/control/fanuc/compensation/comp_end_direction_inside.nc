%
O0001
(rule: F 4.3 G40 I J at a corner that closes)
(expect: to X0 Y20)
(expect: to X0 Y5)
(expect: to X35 Y5)
(expect: to X20 Y40)
G10L12P1R5.
G17G90G40
M3S1000
G00X0.Y20.
G41D1G01X0.Y0.F200.
X40.
G40X20.Y40.I0.J1.
M30
%
