%
O0001
(rule: F 12 X1000, X1000., X[1000])
(expect: to X1)
(expect: to X900)
(expect: to X800)
G00X1000
X900.
X[800]
M30
%
