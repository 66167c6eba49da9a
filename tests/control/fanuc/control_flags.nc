%
O0001
(rule: F 6.5 #3003, #3004: 0 at power-on; what they suppress is the operator's)
(expect: #1=0)
(expect: #2=0)
(expect: #3003=1)
(expect: to X1)
#1=#3003
#2=#3004
#3003=1
G00X1.
M30
%
