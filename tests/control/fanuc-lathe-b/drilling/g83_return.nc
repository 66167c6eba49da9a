%
O0001
(rule: F 2.3, 5.4 T-B: G99 comes back to R, G98 to the start)
(expect: path Z10 Z2 z-22f0.1 Z2 Z10)
G90 G95 G97 S500 M03
G00 X0. Z10.
G99 G83 Z-22. R-8. F0.1
G80
G00 Z10.
M30
%
