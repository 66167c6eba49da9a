%
O0001
(rule: F 5.3 G84 with Q: in strokes, back by No.5213 between them; the last stroke is what is left)
(expect: path Z20 X10 Z2 z-2f1 z-1 z-6 z-5 z-10 z2 Z20)
G95
G00Z20.
M29S500
G84X10.Z-10.R2.Q4.F1.
G80
M30
%
