%
O0001
(rule: F 2.3 a lathe has no G16: PS0010)
(expect: alarm PS0010 K5002 at 5:1)
G16
M30
%
