%
O0001
(rule: F 5.6 G76: cuts of equal section end at the allowance but for a rounding: 0.3 times the root of 9 is 0.92 - 0.02)
(expect: path X30Z5 X27.4 t1.5:z-25 X30 Z5 X27.151 t1.5:z-25 X30 Z5 X26.961 t1.5:z-25 X30 Z5 X26.8 t1.5:z-25 X30 Z5)
(expect: path X26.658 t1.5:z-25 X30 Z5 X26.53 t1.5:z-25 X30 Z5 X26.413 t1.5:z-25 X30 Z5 X26.303 t1.5:z-25 X30 Z5)
(expect: path X26.2 t1.5:z-25 X30 Z5 X26.16 t1.5:z-25 X30 Z5)
T0303
G97 S800 M3
G0 X30. Z5.
G76 P010000 Q50 R0.02
G76 X26.16 Z-25. P920 Q300 F1.5
M30
%
