%
O0001
(rule: F 4.3, 3.3: G53 and G28 of the tool axis leave the cutter on the normal, and the contour goes on)
(expect: path X-20Z5 x0y-5f100 x20 Z0 x45 y20 Z5 Z0 y40 x60)
G10L12P1R5.
S100M3
G0X-20.Y0Z5.
G42D1G1X0F100
X20.
G53Z0
X40.
Y20.
G28Z5.
G1Z0
Y40.
G40X60.
M30
%
