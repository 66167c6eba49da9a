%
O0001
(rule: F 3.6 G07.1 C0 without a cylinder)
(machine: driven)
(expect: alarm PS0175 K5544 at 6:1)
G07.1 C0
M30
%
