%
O00001
(rule: Haas GOTO and IF: on at a block number)
(expect: #101=2)
(expect: to X2)
#1=5
IF[#1GT3]GOTO20
G00 X1.
N20 #101=2
G00 X2.
M30
%
