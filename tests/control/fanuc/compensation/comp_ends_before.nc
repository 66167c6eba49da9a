%
O0001
(rule: F 3.4 G52 behind the compensation)
(expect: path x10y5f100 x20 x50y0 x41)
T1M6S500M3
G41D1G01X10.Y0F100.
X20.
G40X50.
G52X1.
X40.
M30
%
