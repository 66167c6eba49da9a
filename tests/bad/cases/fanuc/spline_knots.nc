%
O0001
G01 X0. Y0. F200.
G06.2 P2 K0. X0. Y0.
K0. X10. Y0.
K1.
M30
%
(expect: 6:1 PS5116 the knots of the spline are not as many as control points and degree + 1)
(exit: 3)
