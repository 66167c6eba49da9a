%
O0001
(rule: F 2.3 T-A: X and W in one block)
(expect: path X50Z2 X46 z-18f0.2 x50 Z2)
G99 G97 S500 M03
G00 X50. Z2.
G90 X46. W-20. F0.2
M30
%
