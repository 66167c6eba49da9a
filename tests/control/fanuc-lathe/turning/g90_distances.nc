%
O0001
(rule: F 5.5, 2.3 G90: U and W count from the start of the cycle)
(expect: path X50Z2 X46 z-18f0.2 x50 Z2 X42 z-18 x50 Z2)
G99 G97 S500 M03
G00 X50. Z2.
G90 U-4. W-20. F0.2
U-8.
M30
%
