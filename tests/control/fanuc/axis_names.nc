%
O0001
(rule: F 6.4 AX and AXNUM)
(expect: alarm PS0199 K5407 at 5:4)
#1=AXNUM[X]
M30
%
