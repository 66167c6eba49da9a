%
O0001
(rule: F 4.3 SUP = 1: the same contour backwards with G42)
(expect: path Y-20 x26.499y32.785f100 x25y35 x-5 y-2.071 x20y-20)
G10L12P1R5.
G0X0Y-20.S100M3
G42D1G1X20.Y30.F100
X0
Y0
G40G1X20.Y-20.
M30
%
