%
O0001
G01 X0. Y0. F200.
G06.2 P2 K0. X5. Y0.
K0. X10. Y0.
K1.
K1.
M30
%
(expect: 4:1 PS5117 the first control point of the spline is 5 mm from the tool)
(exit: 3)
