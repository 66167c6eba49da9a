%
O0001
(rule: F 1.4 a skip level that is off does nothing)
(skip: 2)
(expect: #1=2)
N10 #1=1
/3 N20 #1=2
M30
%
