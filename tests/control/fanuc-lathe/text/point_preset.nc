%
O0001
(rule: case 7: what a block says for the cycle behind it are allowances and ways, in increments by custom)
(expect: path X20Z5 X0.02)
(expect: warning K5902 at 10:4)
T0101
S500 M3
G0 X20. Z5.
G76 P010060 Q100 R100
G0 X20
M30
%
