%
O0001
(rule: F 5.5: single cycles are of group 01, so a code of one motion is executed in their mode; their words end with it)
(expect: path X62Z2 X60 z-5f0.2 x62 Z2 X0Z0 X62Z2 X58 x60z-5 x62 Z2 X0Z0 X58 z-4 x0 Z0)
G99 G97 S500 M03
G00 X62. Z2.
G90 X60. Z-5. F0.2
G28 U0 W0
G00 X62. Z2.
G90 X60. Z-5. R-1.
G53 X0 Z0
X58. Z-4.
G28 U0 W0
M30
%
