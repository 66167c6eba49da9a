%
O0001
(rule: F 6.1 not so few that it is another word)
(expect: alarm PS0199 K5407 at 6:4)
#1=PO[2,3]
#2=P[1]
M30
%
