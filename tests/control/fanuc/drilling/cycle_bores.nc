%
O0001
(rule: F 5.2 G85, G89 out at feed to R; G86 at rapid; G88 by hand)
(expect: path Z20 X10 Z2 z-5f100 z2 Z20 X20 Z2 z-5 z2 Z20 X30 Z2 z-5 Z20 X40 Z2 z-5 Z20)
(expect: stop)
M3S1000
G00X0Y0Z20.
G98G85X10.Z-5.R2.F100
G89X20.P100
G86X30.
G88X40.P100
G80
M30
%
