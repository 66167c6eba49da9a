%
O0001
T1 M6
S500 M3
G0 X0 Y0 Z5. F500
G81 Z10. R2.
M30
%
(expect: 6:1 K5253 the bottom at Z 10 mm must lie below Z 2 mm, where the feed begins)
(exit: 3)
