%
O0001
(rule: F 4.3 G52 behind the way to the contour: that ends where it is programmed)
(expect: path X-20 x0f200 x55y-5 y30 x80)
G10L12P1R5.
G90G54G17G0X-20.Y0
S2000M3
G42D1G1X0F200.
G52X10.Y0
X40.
Y30.
G40X70.
M30
%
