%
O0001
(rule: F 5.3 G74 with Q: a left-hand thread in strokes; P is the dwell at the bottom)
(expect: path Z20 X10 Z2 z-4f1 z-3 z-10 z2 Z20 X20 Z2 z-4 z-3 z-10 z2 Z20 X30 Z2 z-4 z-3 z-10 z2 Z20)
G95
G00Z20.
M29S500
G74X10.Z-10.R2.Q6.F1.
G80
M29S500
G74X20.Z-10.R2.Q6.P500F1.
G80
M29S500
G84X30.Z-10.R2.Q6.P500F1.
G80
M30
%
