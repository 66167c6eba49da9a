%
O0001
(rule: F 5.6 G76: cuts at dd*sqrt n, finishing cuts, one flank, pull-out r)
(expect: path X24Z5)
(expect: path Z4.711 X19 t2:z-28 t2.8284:x23z-30 X24 Z5)
(expect: path Z4.592 X18.586 t2:z-28 t2.8284:x22.586z-30 X24 Z5)
(expect: path Z4.5 X18.268 t2:z-28 t2.8284:x22.268z-30 X24 Z5)
(expect: path Z4.452 X18.1 t2:z-28 t2.8284:x22.1z-30 X24 Z5)
(expect: path Z4.423 X18 t2:z-28 t2.8284:x22z-30 X24 Z5)
(expect: path Z4.423 X18 t2:z-28 t2.8284:x22z-30 X24 Z5)
G99 G97 S500 M03
G00 X24. Z5.
G76 P021060 Q100 R0.05
G76 X18. Z-30. P1000 Q500 F2.
M30
%
