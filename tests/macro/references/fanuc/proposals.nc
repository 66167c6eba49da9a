O0001
N10 G00 X0.
N20 X1.
GOTO 1
(    ^ proposes: 10 20 40)
M98 P1
(    ^ proposes: 1 12 2)
N40 M30
O0002
N50 M99
( ^ outline: program 1 1, call 1 6, program 2 9)
