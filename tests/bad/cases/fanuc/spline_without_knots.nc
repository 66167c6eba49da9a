%
O0001
G01 X0. Y0. F200.
G06.2 P3 X5. Y5.
X10. Y0.
M30
%
(expect: 4:1 PS5116 the knots of the spline are missing)
(exit: 3)
