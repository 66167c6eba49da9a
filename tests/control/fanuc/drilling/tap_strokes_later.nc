%
O0001
(rule: F 5.1, 5.3: Q is modal in the cycle mode; said at a later hole, it taps that one in strokes)
(expect: path Z20 X10 Z5 z-10f1 z5 Z20 X20 Z5 z-1 z0 z-7 z-6 z-10 z5 Z20 X30 Z5 z-1 z0 z-7 z-6 z-10 z5 Z20)
G00Z20.
M29S1000
G84X10.Z-10.R5.F1000
X20.Q6.
X30.
G80
M30
%
