%
O00001
(rule: Haas IF THEN: one assignment in the same block)
(expect: #100=1)
(expect: #101 vacant)
IF [1 EQ 1] THEN #100=1
IF [1 EQ 2] THEN #101=1
M30
%
