%
O0001
(rule: F 2.2 G18, 3.5: CCW in Z, X; vector of 12)
(expect: to X0 Z20 ccw I0 K10)
G18G03X0Z20.I0K10.F100
M30
%
