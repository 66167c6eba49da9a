%
O0001
(rule: F 3.4 G10 L52: N is the number of the parameter)
(expect: alarm PS0231 K5575 at 6:1)
G10L52
R1
G11
M30
%
