%
O0001
M198 P2
M30
O0002
M198 P2
M99
%
(expect: 6:1 PS1080 DUPLICATE DEVICE SUB PROGRAM CALL: a program from outside calls another one from outside)
(exit: 3)
