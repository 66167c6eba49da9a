%
O00001
(rule: Haas G12: without D that of the last D acts, though G40 has ended it; D0 is none)
(expect: path X10Y5 Z2 z-5f100 x13y8 cw:x16y5 cw:x13y2 x10y5 Z2 z-5 x15y10 cw:x20y5 cw:x15y0 x10y5 Z2)
T1 M06
S500 M03
G40 D3
G00 X10. Y5.
Z2.
G12 I10. Z-5. F100.
G12 I10. D0 Z-5.
M30
%
