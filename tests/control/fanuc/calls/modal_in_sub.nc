%
O0001
(rule: F 6.8 motions of a subprogram call as well)
(expect: #100=2)
G00
G66P2
M98P3
G67
M30
O0002
#100=#100+1
M99
O0003
X1.
X2.
M99
%
