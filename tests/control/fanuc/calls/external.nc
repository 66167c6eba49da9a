%
O0001
(rule: F 6.8 M198)
(expect: #500=2)
M198P12L2
M30
%
