%
O0001
(rule: F 6.7 what stands behind M30 is not executed)
(expect: #1=1)
#1=1
M30
#1=2
#3000=1(NEVER)
M30
%
