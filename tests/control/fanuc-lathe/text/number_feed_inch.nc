%
O0001
(rule: F 1.6, 2.1: F without a point in inches, on a lathe 0.0001 in per revolution; under G98 0.01 in/min)
(expect: to X12.7 F0.0254)
(expect: to X25.4 F25.4)
M3S1000
G20
G01X1.F10
G98X2.F100
M30
%
