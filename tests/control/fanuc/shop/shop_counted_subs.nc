%
O0001
(rule: F 6.8 P with the passes in front, L, a return to a block of the caller)
(expect: path X1 X2 X3 X4 X5 Y2)
(expect: #100=5)
G91G00
M98P0032001
M98P2001L2
M98P2002
G90X99.
N100G90Y2.
M30
O2001
X1.
#100=#100+1
M99
O2002
M99P100
%
