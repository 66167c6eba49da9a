%
O0001
(rule: F 5.5 G90: R against the way in X, as far as the start)
(expect: path X50 x46z-20f0.2 x50 Z0)
G99 G97 S500 M03
G00 X50. Z0.
G90 X46. Z-20. R2. F0.2
M30
%
