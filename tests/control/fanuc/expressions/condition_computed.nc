%
O0001
(rule: F 6.4 a comparison is no number: PS0114)
(expect: alarm PS0114 K5401 at 6:11)
#1=3
IF[[#1EQ3]+1EQ2]GOTO9
#4=1
N9M30
%
