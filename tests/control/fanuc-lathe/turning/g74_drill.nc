%
O0001
(rule: F 5.6 G74: without X and P a hole in strokes)
(expect: path Z5 z-5f0.1 Z-4.5 z-15 Z-14.5 z-22 Z5)
G99 G97 S500 M03
G00 X0. Z5.
G74 R0.5
G74 Z-22. Q10000 F0.1
M30
%
