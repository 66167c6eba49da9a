%
O0001
(rule: F 6.4 ADP is obsolete; told by what it is)
(expect: alarm  K5018 at 5:4)
#1=ADP[#2]
M30
%
