%
O0001
(rule: F 5.6 G71: C is A moved by dU/2 and dW, cuts counted from C, 45 degrees off, then along the shape, G70 with the F of the shape)
(expect: path X62Z2 X62.4Z2.1)
(expect: path X58.4 z-29.9f0.25 x59.4z-29.4 Z2.1 X54.4 z-29.9 x55.4z-29.4 Z2.1)
(expect: path X50.4 z-29.9 x51.4z-29.4 Z2.1 X46.4 z-29.9 x47.4z-29.4 Z2.1)
(expect: path X42.4 z-29.9 x43.4z-29.4 Z2.1 X38.4 z-28.4 x39.4z-27.9 Z2.1)
(expect: path X34.4 z-25.4 x35.4z-24.9 Z2.1 X30.4 z-22.4 x31.4z-21.9 Z2.1)
(expect: path X26.4 z-19.4 x27.4z-18.9 Z2.1 X22.4 z-16.4 x23.4z-15.9 Z2.1)
(expect: path X20.4 z-14.9 x40.4z-29.9 x60.4 X62Z2)
(expect: path X20 z-15f0.12 x40z-30 x60 X62Z2 X100)
G99 G97 S500 M03
G00 X62. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G00 X20.
G01 Z-15. F0.12
X40. Z-30.
N20 X60.
G70 P10 Q20
G00 X100.
M30
%
