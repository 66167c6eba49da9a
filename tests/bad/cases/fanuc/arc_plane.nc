%
O0001
G17
G00 X0. Y0. Z0.
G02 X10. Z10. I5. K0. F100.
M30
%
(expect: 5:19 PS0021 ILLEGAL PLANE SELECT: `K` is no centre word of the working plane)
(exit: 3)
