%
O0001
(rule: F 6.2 #0 is read only: PS0116)
(expect: alarm PS0116 K5411 at 5:1)
#0=5
M30
%
