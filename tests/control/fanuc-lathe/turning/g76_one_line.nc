%
O0001
(rule: F 5.6 G76 in one line: K height, D first cut, A angle, the rest are settings)
(expect: path X24Z5 X19 t2:z-28 t2.8284:x23z-30 X24 Z5 X18.586 t2:z-28 t2.8284:x22.586z-30 X24 Z5)
(expect: path X18.268 t2:z-28 t2.8284:x22.268z-30 X24 Z5 X18.1 t2:z-28 t2.8284:x22.1z-30 X24 Z5 X18 t2:z-28 t2.8284:x22z-30 X24 Z5)
G99 G97 S500 M03
G00 X24. Z5.
G76 X18. Z-30. K1. D500 A0 F2.
M30
%
