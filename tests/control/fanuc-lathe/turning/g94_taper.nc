%
O0001
(rule: F 5.5 G94 with R: along Z)
(expect: path X50Z2 Z-5 x20z-2f0.2 z2 X50)
G99 G97 S500 M03
G00 X50. Z2.
G94 X20. Z-2. R-3. F0.2
M30
%
