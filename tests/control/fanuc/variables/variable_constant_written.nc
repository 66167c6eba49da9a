%
O0001
(rule: F 6.2 constants are read only)
(expect: alarm PS0116 K5411 at 5:1)
#3101=3
M30
%
