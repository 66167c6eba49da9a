%
O0001
(rule: F 6.8 variables and expressions are passed whole)
(expect: #118=0.333333333)
(expect: #100 vacant)
(expect: #101=-7)
#7=7
G65P9100X[1/3]A#0B-#7
M30
%
