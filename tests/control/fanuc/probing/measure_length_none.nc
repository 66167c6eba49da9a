%
O0001
(rule: F 11 PS0081: G37 without an offset that acts)
(expect: alarm PS0081 K5572 at 5:1)
G37Z10.
M30
%
