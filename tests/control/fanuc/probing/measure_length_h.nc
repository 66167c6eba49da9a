%
O0001
(rule: F 11 PS0082: H beside G37)
(expect: alarm PS0082 K5573 at 6:1)
G43H1Z100.
G37Z10.H2
M30
%
