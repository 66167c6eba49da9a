%
O0001
(rule: F 5.4 G85: in at F, out at twice F)
(expect: path Z10 Z2 z-22f0.1 z2f0.2 Z10 X20 z-1f0.1)
G99 G97 S500 M03
G00 X0. Z10.
G85 Z-22. R-8. F0.1
G80
G00 X20.
G01 Z-1.
M30
%
