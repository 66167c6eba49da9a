%
O0001
(rule: F 2.5 T0101: the offset acts; 3.3 G53 without it)
(expect: to X20 Z2)
(expect: #1=-40)
(expect: #2=-30)
G10P10001X-40.Z-30.
T0101
S500M03
G00X40.Z2.
#1=#5081
#2=#5083
M30
%
