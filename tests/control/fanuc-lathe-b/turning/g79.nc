%
O0001
(rule: F 2.3, 5.5 T-B: G79 is the single cycle across)
(expect: path X50Z2 Z-2 x20f0.2 z2 X50)
G90 G95 G97 S500 M03
G00 X50. Z2.
G79 X20. Z-2. F0.2
M30
%
