%
O0001
(rule: F 6.4 whole addresses are rounded)
(expect: #1=1)
#1=499.6
G04P#1
G04X[0.5]
#1=1
M30
%
