%
O0001
(rule: F 5.6: F, S and T of the shape do not count for roughing, those of G71 do, G70 takes them)
(expect: path X30Z2 X26 z-10f0.3 x27z-9.5 Z2 X22 z-10 x23z-9.5 Z2 X20 z-10 x30 Z2 X20 z-10f0.1 x30 Z2)
G99 G97 S500 M03 F0.2
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.3 S800
N10 G00 X20. S1200
G01 Z-10. F0.1 T0303
N20 X30.
G70 P10 Q20
M30
%
