%
O0001
(rule: F 5.6 G71: without allowances the cuts count from A itself)
(expect: path X62Z2 X58 z-30f0.25 x59z-29.5 Z2 X54 z-30 x55z-29.5 Z2 X50 z-30 x51z-29.5 Z2 X46 z-30 x47z-29.5 Z2)
(expect: path X42 z-30 x43z-29.5 Z2 X38 z-28.5 x39z-28 Z2 X34 z-25.5 x35z-25 Z2 X30 z-22.5 x31z-22 Z2)
(expect: path X26 z-19.5 x27z-19 Z2 X22 z-16.5 x23z-16 Z2 X20 z-15 x40z-30 x60 X62Z2)
G99 G97 S500 M03
G00 X62. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.25
N10 G00 X20.
G01 Z-15.
X40. Z-30.
N20 X60.
M30
%
