%
O0001
(rule: F 11 PS1144 G10 without L)
(expect: alarm PS1144 K5283 at 5:1)
G10P1X0.
M30
%
