%
O0001
(rule: F 5.6 G71 type II: X and Z in the first block, pockets one after the other, lifted straight off)
(expect: path X40Z2 X36 z-31f0.2 x37 Z2 X32 z-10 x33 X37 Z-12.5 x32 z-27 x33)
(expect: path X40 Z2 X30Z0 z-10 x34 x30z-15 z-25 x40z-35 Z2)
G99 G97 S500 M03
G00 X40. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.2
N10 G00 X30. Z0.
G01 Z-10.
X34.
X30. Z-15.
Z-25.
N20 X40. Z-35.
M30
%
