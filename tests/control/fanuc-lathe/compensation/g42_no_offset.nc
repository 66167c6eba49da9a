%
O0001
(rule: F 4.3 offset 0: no radius)
(expect: path X30Z5 x20z2f100 z-10 x30)
T0100
G98S500M03
G00X30.Z5.
G42G01X20.Z2.F100.
Z-10.
G40X30.
M30
%
