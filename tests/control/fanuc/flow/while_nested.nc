%
O0001
(rule: F 6.7 three levels)
(expect: #4=24)
#1=0
#4=0
WHILE[#1LT2]DO1
#1=#1+1
#2=0
WHILE[#2LT3]DO2
#2=#2+1
#3=0
WHILE[#3LT4]DO3
#3=#3+1
#4=#4+1
END3
END2
END1
M30
%
