%
O0001
(rule: F 1.6 F without a point: 1 mm/min; under G95 0.01 mm)
(expect: to X1 F100)
(expect: to X2 F0.25)
M3S1000
G01X1.F100
G95X2.F25
M30
%
