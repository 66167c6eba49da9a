%
O0001
(rule: F 5.6 G71: dU and dW below 0: a bore cut towards Z plus)
(expect: path X20Z-30 X24 z-10f0.2 x23z-10.5 Z-30 X28 z-10 x27z-10.5 Z-30 X30 z-10 x20 Z-30)
G99 G97 S500 M03
G00 X20. Z-30.
G71 U2. R0.5
G71 P10 Q20 F0.2
N10 G00 X30.
G01 Z-10.
N20 X20.
M30
%
