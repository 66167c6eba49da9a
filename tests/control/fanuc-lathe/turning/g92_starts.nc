%
O0001
(rule: F 5.5 G92 Q: each block of the mode has its own start angle, without Q it is 0)
(expect: path X62Z2 X60 t2@90:z-19 t2.8284:x62z-20 Z2 X59 t2:z-18.5 t2.8284:x62z-20 Z2 X58 t2@180:z-18)
(expect: path t2.8284:x62z-20 Z2 X57 t2:z-18 t2.8284:x61z-20 X62 Z2 X56 t2@45:z-18 t2.8284:x60z-20 X62 Z2)
(expect: path X55 t2:z-18 t2.8284:x59z-20 X62 Z2)
G99 G97 S500 M03
G00 X62. Z2.
G92 X60. Z-20. F2. Q90000
X59. Q0
X58. Q180000
X57.
G92 X56. Q45000
G92 X55.
M30
%
