%
PROGRAM MAIN
(rule: 4 passes behind the program that a word calls)
(expect: #31=6)
CALL COUNT
CALL COUNT Q2
#32=3
CALL P200 Q#32
M2
PROGRAM COUNT
#31=[#31+1]
RTS
PROGRAM P200
#31=[#31+1]
RTS
%
