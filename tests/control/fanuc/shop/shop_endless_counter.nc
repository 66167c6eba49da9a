%
O0123(M99 L, M99 P, ENDLESS WITH COUNTER)
(rule: F 6.8 M99: the main program from its head, M99 L0 out of the repeats)
(expect: path X1 X2 X3)
(expect: #500=3)
(expect: #501=2)
(expect: #502=1)
#500=#500+1
G90G54G0X#500
IF[#500LT3]GOTO10
GOTO20
N10M99
N20
M98P1123L5
M30
O1123
#501=#501+1
IF[#501GE2]THEN#502=1
IF[#502EQ1]GOTO5
M99
N5M99L0
%
