%
O0001
(rule: F 5.6 G76 X Z P Q: without Q there is no first cut)
(expect: path X60Z2)
(expect: alarm PS0066 K5009 at 9:1)
G99 G97 S500 M03
G00 X60. Z2.
G76 P010060 Q50 R0.05
G76 X58. Z-5. P900 F1.5
M30
%
