%
O0001
(rule: F 4.4 G41 with I, J and K: in space, not executed; with two of them it is that of the plane)
(expect: alarm  K5018 at 5:1)
G41X10.Y0Z0I1.J0K0.5D1
M30
%
