%
O00001
(rule: Haas G13: I is the radius of the pocket, and the middle of the cutter goes nearer by that of offset D)
(expect: path X10Y5 Z2 z-5f100 x13y2 ccw:x16y5 ccw:x13y8 x10y5 Z2)
T1 M06
S500 M03
G00 X10. Y5.
Z2.
G13 I10. D3 Z-5. F100.
M30
%
