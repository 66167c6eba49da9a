%
O0001
(rule: F 3.3, 3.4, 3.7: not inside G41: the compensation ends first)
(expect: alarm  K5351 at 8:1)
T1M6S500M3
G41D1G01X10.Y0F100.
X20.
G68X0Y0R30.
X30.
G40X50.
M30
%
