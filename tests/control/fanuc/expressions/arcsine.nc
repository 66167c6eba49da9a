%
O0001
(rule: F 12 ASIN with NAT = 0)
(expect: #1=30)
(expect: #2=330)
(expect: #3=120)
#1=ASIN[0.5]
#2=ASIN[-0.5]
#3=ACOS[-0.5]
M30
%
