%
O0001
(rule: F 2.3 G32 is of a lathe: PS0010)
(expect: alarm PS0010 K5002 at 5:1)
G32Z-10.F1.
M30
%
