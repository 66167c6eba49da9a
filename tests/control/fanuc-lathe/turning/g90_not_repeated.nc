%
O0001
(rule: F 5.5: a block without X or Z does not repeat the cycle)
(expect: path X50Z2 X46 z-20f0.2 x50 Z2 X42 z-20f0.1 x50 Z2)
G99 G97 S500 M03
G00 X50. Z2.
G90 X46. Z-20. F0.2
M08
F0.1
X42.
M30
%
