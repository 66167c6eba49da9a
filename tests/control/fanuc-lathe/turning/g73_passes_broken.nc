%
O0001
(rule: F 5.6 G73 d: an integer of 1 at least, PS0321)
(expect: path X30Z2)
(expect: alarm PS0321 K5253 at 9:1)
G99 G97 S500 M03
G00 X30. Z2.
G73 U4. W1. R1.5
G73 P10 Q20 U0.4 W0.1 F0.2
N10 G00 X20.
N20 G01 Z-10.
M30
%
