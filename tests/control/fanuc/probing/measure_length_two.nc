%
O0001
(rule: F 11 PS0083: G37 names one axis)
(expect: alarm PS0083 K5571 at 6:1)
G43H1Z100.
G37X10.Z10.
M30
%
