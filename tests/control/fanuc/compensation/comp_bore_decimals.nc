%
O0001
(rule: F 4.3 inner corner: a bore by a quarter, a full circle and a quarter whose centre has three decimals)
#13001=4.
T1M6
S1000M3
G17G90G40G21
G0X0Y0Z0
G1F500G41D1X10.Y-10.
G3X20.Y0I0J10.
G3I-20.
G3X10.Y10.I-9.999J0.001
G1G40X0Y0
M30
%
