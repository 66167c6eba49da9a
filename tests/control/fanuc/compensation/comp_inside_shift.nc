%
O0001
(rule: F 4.3, 3.4: before G52 the line ends where it is programmed, the next one leads to its corner)
(expect: path X-20Y-20 x-5y0f200 y45 x40y40 x95y45 y-5 x10 x-10y-20)
G10L12P1R5.
G90G54G17G0X-20.Y-20.
S2000M3
G41D1G1X0Y0F200.
Y40.
X40.
G52X10.Y0
X80.Y40.
Y0
X0
G40X-20.Y-20.
M30
%
