%
O0001
(rule: F 3.6 G07.1 on a machining centre: an axis that the machine does not have)
(expect: alarm PS0175 K5541 at 5:1)
G07.1 A20.
M30
%
