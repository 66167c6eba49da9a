%
O0001
(rule: F 5.6 G71: each cut begins with the G code of the first block, here at feed)
(expect: path X30Z2 x26f0.2 z-10 x27z-9.5 Z2 x22 z-10 x23z-9.5 Z2 x20 z-10 x30 Z2)
G99 G97 S500 M03
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.2
N10 G01 X20. F0.05
Z-10.
N20 X30.
M30
%
