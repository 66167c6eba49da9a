%
O0001
(rule: F 5.4 G83: without Q one stroke, P is the dwell)
(expect: path Z10 Z2 z-22f0.1 Z10)
G99 G97 S500 M03
G00 X0. Z10.
G83 Z-22. R-8. P500 F0.1
G80
M30
%
