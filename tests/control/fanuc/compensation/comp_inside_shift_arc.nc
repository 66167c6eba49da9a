%
O0001
(rule: F 4.3: behind an arc the cutter cannot come straight to the programmed end)
(expect: alarm  K5668 at 10:1)
G10L12P1R5.
G90G54G17G0X-20.Y0
S2000M3
G42D1G1X0F200.
X20.
G3X40.Y20.R20.
G52X10.
G1Y40.
G40X70.
M30
%
