%
O00001
(rule: Haas GOTO and IF: on at a block number)
(expect: #101=2)
(expect: to X2)
#1=5
IF [#1 GT 3] GOTO 20
G00 X1.
N20 #101=2
G00 X2.
M30
%
