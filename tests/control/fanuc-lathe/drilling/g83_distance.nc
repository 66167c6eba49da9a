%
O0001
(rule: F 5.4 G83: W is a distance from R)
(expect: path Z10 Z2 z-8f0.1 Z2 Z-7 z-18 Z10)
G99 G97 S500 M03
G00 X0. Z10.
G83 W-20. R-8. Q10000 F0.1
G80
M30
%
