%
O0001
(rule: F 12 six: PS0118)
(expect: alarm PS0118 K5405 at 5:12)
#1=SIN[[[[[[1]]]]]]
M30
%
