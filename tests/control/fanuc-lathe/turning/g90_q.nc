%
O0001
(rule: F 5.5: G90 X Z R F has no Q)
(expect: path X62Z2 X60 z-5f0.2 x62 Z2)
(expect: alarm PS0009 K5010 at 9:6)
G99 G97 S500 M03
G00 X62. Z2.
G90 X60. Z-5. F0.2
X59. Q2000
M30
%
