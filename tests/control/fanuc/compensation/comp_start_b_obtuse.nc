%
O0001
(rule: F 4.3 SUP = 1: at an obtuse corner to the intersection with the way from the start)
(expect: path Y-20 x-5y2.071f100 x15y22.071 y55 x50y50)
G10L12P1R5.
G0X0Y-20.S100M3
G41D1G1X0Y0F100
X20.Y20.
X20.Y50.
G40X50.Y50.
M30
%
