%
O0001
(rule: F 6.8 M98 P L)
(expect: #500=3)
M98P12L3
M30
%
