%
O0001
(rule: F 12 ACOS[-0.5], ASIN[-0.5])
(expect: #1=120)
(expect: #2=330)
#1=ACOS[-0.5]
#2=ASIN[-0.5]
M30
%
