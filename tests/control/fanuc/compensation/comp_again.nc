%
O0001
(rule: F 4.3 G42 again in the mode: on the normal of the block before, from there to the next corner)
(expect: path X-20 x0y-5f200 x25 y20 x45y15 y40 x60)
G10L12P1R5.
G90G54G17G0X-20.Y0
S2000M3
G42D1G1X0F200.
X20.
Y20.
G42X40.
Y40.
G40X60.
M30
%
