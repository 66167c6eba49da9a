%
(rule: comments of both kinds are read, alone, behind words and behind statements)
(expect: V1=3)
(expect: path X5Y2)
; alone
V1=3 ; behind an assignment
V1=V1 (between) ; and behind
G0 X5 (a word) Y2 ; behind words; twice
IF V1 EQ 4 N9 ; behind a condition
N9 M2
