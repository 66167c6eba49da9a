%
O0001
(rule: F 5.5 G90: R against the way in X is no more than that way)
(expect: alarm  K5253 at 7:1)
G99 G97 S500 M03
G00 X50. Z0.
G90 X46. Z-20. R5. F0.2
M30
%
