%
O0001
(rule: F 6.8 P30012 is O0012 three times)
(expect: #500=3)
(expect: to X1)
(expect: to X2)
(expect: to X3)
G00
M98P30012
M30
%
