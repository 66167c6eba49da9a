%
O0001
(rule: F 5.4 G83: R is a distance from the start of the cycle, Z a coordinate, strokes, back to the start)
(expect: path Z10 Z2 z-8f0.1 Z2 Z-7 z-18 Z2 Z-17 z-22 Z10 X20)
G99 G97 S500 M03
G00 X0. Z10.
G83 Z-22. R-8. Q10000 F0.1
G80
G00 X20.
M30
%
