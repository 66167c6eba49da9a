%
O0001
(rule: F 5.5 G90 with R: radius at the start less that at the end, R holds for the blocks behind)
(expect: path X50 X36 x46z-20f0.2 x50 Z0 X32 x42z-20 x50 Z0)
G99 G97 S500 M03
G00 X50. Z0.
G90 X46. Z-20. R-5. F0.2
X42.
M30
%
