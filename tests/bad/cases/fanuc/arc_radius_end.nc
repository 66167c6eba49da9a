%
O0001
G00 X20. Y0.
G03 X0. Y20.05 I-20. J0. F100.
M30
%
(expect: 4:16 PS0020 OVER TOLERANCE OF RADIUS: the end of the arc is not on its circle: radius 20 at the start, 20.05 at the end)
(exit: 3)
