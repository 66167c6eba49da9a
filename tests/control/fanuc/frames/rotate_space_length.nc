%
O0001
(rule: F 3.7, 4.2: G43 and the rotation in space are nested)
(expect: alarm PS0049 K5667 at 8:1)
T1M6
G68X0Y0Z0I1.J0K0R30.
G43H1Z50.
G69
M30
%
