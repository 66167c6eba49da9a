%
O0001
T1 M6
G0 X0. Y0.
X1. M05 M30
M30
%
(expect: 5:9 PS5016 ILLEGAL COMBINATION OF M CODES: `M30` does not stand beside `M05`)
(exit: 3)
