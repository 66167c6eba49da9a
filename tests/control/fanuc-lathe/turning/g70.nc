%
O0001
(rule: F 5.6 G70: the blocks of the shape with all that they say, rapid to the start, on behind G70)
(expect: path X40Z2 X20 z-10f0.1 x30z-15f0.05 X40Z2 X60)
G99 G97 S500 M03
G00 X40. Z2. F0.3
G70 P10 Q20
G00 X60.
M30
N10 G00 X20.
G01 Z-10. F0.1
N20 X30. Z-15. F0.05
%
