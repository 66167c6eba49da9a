%
(rule: a loop is left by one word, and its pass ended by another, from inside of a condition)
(expect: V1=5)
(expect: V2=5)
V1=0
V2=0
REPEAT 10
V1=V1+1
WHEN V1 EQ 2 DO
NEXT
END
WHEN V1 EQ 5 DO
LEAVE
END
REPEAT 2
V2=V2+1
WHEN V2 EQ 3 DO
LEAVE
END
AGAIN
AGAIN
G0 X0
M2
