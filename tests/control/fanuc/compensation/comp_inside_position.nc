%
O0001
(rule: F 4.3, 3.4: G92 is the place of the tool without its radius; the contour goes on from there)
(expect: path X-20Y-20 x-5y0f200 y45 x40y40 x85y45 x80y20)
(expect: #100=0)
G10L12P1R5.
G90G54G17G0X-20.Y-20.
S2000M3
G41D1G1X0Y0F200.
Y40.
X40.
G92X0Y0
#100=#5001
X40.
G40Y-20.
M30
%
