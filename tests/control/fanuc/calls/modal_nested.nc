%
O0001
(rule: F 6.8 a motion calls the last macro, its motions the one before)
(expect: to X10)
(expect: to Y2)
(expect: to Y1)
G00
G66P100
G66P200
X10.
G67
G67
M30
O0100
Y1.
M99
O0200
Y2.
M99
%
