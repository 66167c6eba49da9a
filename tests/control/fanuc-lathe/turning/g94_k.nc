%
O0001
(rule: F 5.5: G94 has no K; its taper is R)
(expect: path X62Z2)
(expect: alarm PS0010 K5012 at 8:14)
G99 G97 S500 M03
G00 X62. Z2.
G94 X50. Z0. K-1. F0.2
M30
%
