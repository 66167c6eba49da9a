%
O0001
(rule: F 5.5 G90: rapid in X, feed along Z, feed out in X, rapid back, every block with X or Z again)
(expect: path X50Z2 X46 z-20f0.2 x50 Z2 X42 z-20 x50 Z2 X42 z-15 x50 Z2 X60)
G99 G97 S500 M03
G00 X50. Z2.
G90 X46. Z-20. F0.2
X42.
Z-15.
G00 X60.
M30
%
