%
O0001
(rule: F 3.5 the end misses the circle: PS0020)
(expect: alarm PS0020 K5220 at 5:11)
G02X20.Y1.I10.J0F100
M30
%
