%
O0001
(rule: F 5.6 G73: with one pass only the last shift is left)
(expect: path X40Z5 X40.4Z5.1 X20.4 z-9.9f0.2 x30.4z-14.9 X40Z5)
G99 G97 S500 M03
G00 X40. Z5.
G73 U4. W2. R1
G73 P10 Q20 U0.4 W0.1 F0.2
N10 G00 X20.
G01 Z-10.
N20 X30. Z-15.
M30
%
