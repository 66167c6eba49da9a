%
O0001
(rule: F 6.8 in inches the increment is 0.0001)
(expect: #118=0.001)
G20
G65P9100X10
M30
%
