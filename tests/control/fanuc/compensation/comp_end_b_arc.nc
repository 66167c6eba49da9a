%
O0001
(rule: F 4.3 SUP = 1: behind an arc the tangent at its end meets the side of the way out)
(expect: path X30Y-20 x15y-1.18f100 y0 ccw:x5 y-1.18 x-10y-20)
G10L12P1R5.
G0X30.Y-20.S100M3
G41D1G1X20.Y0F100
G3X0Y0R10.
G40G1X-10.Y-20.
M30
%
