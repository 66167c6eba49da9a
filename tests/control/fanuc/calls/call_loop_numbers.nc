%
O0001
(rule: F 6.7 DO numbers count in each program)
(expect: #100=6)
#1=0
WHILE[#1LT2]DO1
G65P2
#1=#1+1
END1
M30
O0002
#2=0
WHILE[#2LT3]DO1
#100=#100+1
#2=#2+1
END1
M99
%
