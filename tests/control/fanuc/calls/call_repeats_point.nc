%
O0001
(rule: F 1.6 L2. of a call: PS0007)
(expect: alarm PS0007 K5005 at 5:6)
M98P2L2.
M30
O2
M99
%
