%
O0001
(rule: F 4.3 G41 twice before the contour begins: the second one says nothing new)
(expect: path X-20 x0y5f200 x15 y30 x-10)
G10L12P1R5.
G90G54G17G0X-20.Y0
S2000M3
G41D1
G41G1X0F200.
X20.
Y30.
G40X-10.
M30
%
