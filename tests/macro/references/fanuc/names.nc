O0001
( Names that stand for numbers of variables hide no jump)
SETVN 500[WIDTH,DEPTH]
IF[[#WIDTH]GT5.]GOTO 10
(                    ^ leads: 6:1)
N10 M30
