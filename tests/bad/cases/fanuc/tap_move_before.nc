%
O0001
S500 M3
G0 X0 Y0 Z5. F500
M29 S500
X5.
G84 Z-10. R2.
M30
%
(expect: 6:1 PS0204 ILLEGAL AXIS OPERATION: axes move between the code for rigid tapping and the tapping cycle)
(exit: 3)
