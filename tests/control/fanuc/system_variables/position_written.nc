%
O0001
(rule: F 6.5 a position cannot be written: PS0116)
(expect: alarm PS0116 K5411 at 5:1)
#5001=5
M30
%
