%
O0001
(rule: F 4.2, 4.3 nose radius: the tip 3 stands on cylinder and face)
(expect: path X30Z5 x20z1.2f100 z-10.8 x30z-10)
G10P10001R0.8Q3
T0101
G98S500M03
G00X30.Z5.
G42G01X20.Z2.F100.
Z-10.
G40X30.
M30
%
