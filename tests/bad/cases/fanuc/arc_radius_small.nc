%
O0001
G00 X0. Y0.
G02 X100. Y0. R10. F100.
M30
%
(expect: 4:15 PS0020 OVER TOLERANCE OF RADIUS: radius 10 does not reach: start and end of the arc are 100 apart)
(exit: 3)
