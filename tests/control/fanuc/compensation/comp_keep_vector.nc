%
O0001
(rule: F 4.3 G38: on the normal of the block before, and as far beside the contour behind it)
(expect: to X0 Y-20)
(expect: to X0 Y-5)
(expect: to X40 Y-5)
(expect: to X50 Y5)
(expect: to X55 Y30)
(expect: to X80 Y30)
G10L12P1R5.
G17G90G40
M3S1000
G00X0.Y-20.
G42D1G01X0.Y0.F200.
X40.
G38X50.Y10.
Y30.
G40X80.
M30
%
