%
O0001
(rule: F 1.1 blanks do not count)
(expect: #1=5)
(expect: #2 vacant)
(expect: to X5)
# 1 = 2 + 3
IF [ #1 EQ 5 ] GOTO 10
#2=1
N10 G00 X #1
M30
%
