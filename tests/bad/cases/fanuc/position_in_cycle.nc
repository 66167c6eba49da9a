%
O0001
S500 M3
T1 M6
M3
G0 X0 Y0 Z5. F500
G81 Z-10. R2.
G92 X0.
M30
%
(expect: 8:1 K5238 a position is set while a cycle is active)
(exit: 3)
