%
O0001
(rule: F 11 PS5117: the first point is where the tool stands)
(expect: alarm PS5117 K5205 at 7:1)
G05.1Q1
G01X0Y0F100M3S500
G06.2P4K0X5.Y0
K0X6.Y0
K0X7.
K0X8.
K1.
K1.
K1.
K1.
G01X9.
M30
%
