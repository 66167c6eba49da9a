%
O0001
(rule: F 5.5 G94: rapid in Z, feed along X, feed back in Z, rapid in X)
(expect: path X50Z2 Z-2 x20f0.2 z2 X50 Z-4 x20 z2 X50)
G99 G97 S500 M03
G00 X50. Z2.
G94 X20. Z-2. F0.2
Z-4.
M30
%
