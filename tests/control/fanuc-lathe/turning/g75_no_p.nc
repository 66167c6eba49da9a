%
O0001
(rule: F 5.6 G75 X Z P Q R: without P there is no stroke)
(expect: path X60Z2)
(expect: alarm PS0066 K5009 at 8:1)
G99 G97 S500 M03
G00 X60. Z2.
G75 X50. Z-5. Q2000 F0.1
M30
%
