%
O0001
(rule: F 4.3 SUP = 1: the way out goes over both ends of the extended sides, as the way in does)
(expect: path X20Y-20 x-5y-2.071f100 y35 x25 x26.499y32.785 x0y-20)
G10L12P1R5.
G0X20.Y-20.S100M3
G41D1G1X0Y0F100
Y30.
X20.
G40G1X0Y-20.
M30
%
