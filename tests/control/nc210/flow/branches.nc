%
;rule: NC-210 12: labels between quotes, alone or in front of words; branches name them without, and compare two values
;expect: E33=4
;expect: path X4 Y5
E33=0
"NEXT"
E33=E33+1
(BLT,E33,4,NEXT)
(BEQ,E33,5,BAD)
(BNE,E33,4,BAD)
(BGE,E33,E33,GOOD)
"BAD"
E33=-1
"GOOD" N30 G0 XE33
(BNC,N50)
N40 G0 X100.
N50 G0 Y5.
M30
