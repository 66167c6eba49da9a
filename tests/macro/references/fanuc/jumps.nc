%
O0001(JUMPS)
N10 #1=#1+1
N20 G00 X0.
GOTO 30
(    ^ leads: 9:1)
IF[#1LT3]GOTO 10
(             ^ leads: 3:1)
N30 X1.
( ^ uses: 5:6 [9:1] 18:6)
GOTO 30
(    ^ leads: 16:1)
GOTO #1
(    ^ leads: computed)
G O T O 9 9
N30 X2.
( ^ uses: 11:6 [16:1])
GOTO 30
(    ^ leads: 9:1)
GOTO 77
(    ^ leads: missing)
M99 P20
(    ^ leads: 4:1)
M30
O0002
N20 G01 X5. F100.
M99 P30
(    ^ leads: of caller)
GOTO 10
(    ^ leads: missing)
M99
%
