%
O0001
(rule: F 4.3 G40 I J: to where the contour would meet the way beside a line in this direction)
(expect: to X0 Y-20)
(expect: to X0 Y-5)
(expect: to X45 Y-5)
(expect: to X60 Y40)
G10L12P1R5.
G17G90G40
M3S1000
G00X0.Y-20.
G42D1G01X0.Y0.F200.
X40.
G40X60.Y40.I0.J1.
M30
%
