%
O0001
(rule: F 4.3 G41 again on an arc: the control says that it would not be right)
(expect: alarm  K5668 at 10:1)
G10L12P1R5.
G90G54G17G0X-20.Y0
S2000M3
G41D1G1X0F200.
X20.
G41G3X40.Y20.R20.
G40G1X-10.
M30
%
