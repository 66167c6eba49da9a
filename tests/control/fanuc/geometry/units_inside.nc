%
O0001
(rule: F 3.1 PS1298: no change of units inside G68)
(expect: alarm PS1298 K5533 at 7:1)
G21
G68X0Y0R30.
G20
M30
%
