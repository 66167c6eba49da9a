%
O0001
(rule: F 5.4, 5.3 G84: F is the pitch under G99, back at R, up at rapid)
(expect: path Z10 Z2 z-22f1.5 z2 Z10)
G99 G97 S500 M03
G00 X0. Z10.
M29 S500
G84 Z-22. R-8. F1.5
G80
M30
%
