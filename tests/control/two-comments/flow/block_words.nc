%
(rule: a jump and a condition name a block by its word)
(expect: V1=3)
(expect: path X3)
V1=0
N10 V1=V1+1
IF V1 LT 3 N10
GOTO N30
N20 G0 X100
N30 G0 XV1
M2
