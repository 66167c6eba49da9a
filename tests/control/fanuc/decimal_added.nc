%
O0001
(rule: F 6.4 ADP is obsolete)
(expect: alarm PS0199 K5407 at 5:4)
#1=ADP[#2]
M30
%
