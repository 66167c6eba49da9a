%
O0001
(rule: F 3.1 T-B: G91 holds in the shape and is as before behind the cycle)
(expect: path X30Z2 X26 z-10f0.2 x27z-9.5 Z2 X22 z-10 x23z-9.5 Z2 X20 z-10 x30 Z2 X50)
G90 G95 G97 S500 M03
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.2
N10 G91 G00 X-10.
G01 Z-12.
N20 X10.
G00 X50.
M30
%
