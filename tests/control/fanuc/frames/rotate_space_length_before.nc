%
O0001
(rule: F 3.7, 4.2: the rotation in space comes before G43)
(expect: alarm PS0049 K5667 at 7:1)
T1M6
G43H1Z50.
G68X0Y0Z0I1.J0K0R30.
M30
%
