%
O0001
(rule: F 12 five brackets, those of functions included)
(expect: #1=1)
#1=SIN[[[[[90]]]]]
M30
%
