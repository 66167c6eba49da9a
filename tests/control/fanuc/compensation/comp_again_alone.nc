%
O0001
(rule: F 4.3 G41 again in a block of its own; at an outside corner there is no corner then, either)
(expect: path X-20 x0y5f200 x20 x14.472y-22.236 x5y-30)
G10L12P1R5.
G90G54G17G0X-20.Y0
S2000M3
G41D1G1X0F200.
X20.
G41
X10.Y-20.
G40X5.Y-30.
M30
%
