%
O0001
(rule: F 4.3 G39: an arc about this corner, no other)
(expect: to X0 Y-20)
(expect: to X0 Y-5)
(expect: to X40 Y-5)
(expect: to X45 Y0 ccw I40 J0 F200)
(expect: to X45 Y35)
(expect: to X20 Y35)
(expect: to X0 Y60)
G10L12P1R5.
G17G90G40
M3S1000
G00X0.Y-20.
G42D1G01X0.Y0.F200.
X40.
G39
Y30.
X20.
G40X0.Y60.
M30
%
