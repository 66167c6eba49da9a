%
O00001
(rule: Haas settings, a distance without a point counts 0.001 mm)
(expect: to X0.01 Y-0.005)
(expect: to X10 Y5)
G00 X10 Y-5
X10. Y5.
M30
%
