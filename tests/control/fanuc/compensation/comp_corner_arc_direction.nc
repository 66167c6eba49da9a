%
O0001
(rule: F 4.3 G39 I J: to the normal of this direction)
(expect: to X0 Y-20)
(expect: to X0 Y-5)
(expect: to X40 Y-5)
(expect: to X43.535534 Y-3.535534 ccw I40 J0)
(expect: to X63.535534 Y16.464466)
(expect: to X80 Y0)
G10L12P1R5.
G17G90G40
M3S1000
G00X0.Y-20.
G42D1G01X0.Y0.F200.
X40.
G39I1.J1.
X60.Y20.
G40X80.Y0.
M30
%
