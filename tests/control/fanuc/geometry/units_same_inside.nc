%
O0001
(rule: F 3.1 the units that act may be said again)
(expect: to X0 Y0)
G21
G68X0Y0R30.
G21
X0Y0
M30
%
