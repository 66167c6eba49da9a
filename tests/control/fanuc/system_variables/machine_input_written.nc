%
O0001
(rule: F 6.5 inputs are read only)
(expect: alarm PS0116 K5411 at 5:1)
#1004=1
M30
%
