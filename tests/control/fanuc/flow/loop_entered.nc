%
O0001
(rule: F 6.7 a jump into a loop: PS1124)
(expect: alarm PS1124 K5435 at 9:1)
#1=0
GOTO10
WHILE[#1LT3]DO1
N10 #1=#1+1
END1
M30
%
