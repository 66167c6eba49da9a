%
O0001
(rule: F 6.4 M3.0 as it stands: PS0007)
(expect: alarm PS0007 K5005 at 5:1)
M3.0
M30
%
