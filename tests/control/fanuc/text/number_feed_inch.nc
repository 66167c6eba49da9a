%
O0001
(rule: F 1.6 F without a point in inches: 0.01 in/min; under G95 0.0001 in; under G93 what it says)
(expect: to X25.4 F2.54)
(expect: to X50.8 F254)
(expect: to X76.2 F0.0635)
(expect: to X101.6 F2)
M3S1000
G20
G94G01X1.F10
X2.F10.
G95X3.F25
G93X4.F2
M30
%
