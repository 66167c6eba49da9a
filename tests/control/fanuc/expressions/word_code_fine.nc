%
O0001
(rule: F 6.4 a G code too fine: PS0010)
(expect: alarm PS0010 K5002 at 6:1)
#1=54.13
G#1
M30
%
