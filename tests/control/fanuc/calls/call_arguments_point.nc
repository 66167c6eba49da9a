%
O0001
(rule: F 6.8 without a point an argument counts increments of its address)
(expect: #100=0.01)
(expect: #113=1000)
(expect: #118=0.01)
G65P9100X10A10S1000
M30
%
