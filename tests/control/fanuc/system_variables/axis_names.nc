%
O0001
(rule: F 6.4 AX and AXNUM)
(expect: #1=1)
#1=AXNUM[X]
M30
%
