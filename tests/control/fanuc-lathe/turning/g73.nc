%
O0001
(rule: F 5.6 G73: the whole shape d times, from dI + dU/2 and dK + dW off to the allowances)
(expect: path X40Z5 X48.4Z7.1 X28.4 z-7.9f0.2 x38.4z-12.9 X44.4Z6.1 X24.4 z-8.9 x34.4z-13.9 X40.4Z5.1 X20.4 z-9.9 x30.4z-14.9 X40Z5)
G99 G97 S500 M03
G00 X40. Z5.
G73 U4. W2. R3
G73 P10 Q20 U0.4 W0.1 F0.2
N10 G00 X20.
G01 Z-10.
N20 X30. Z-15.
M30
%
