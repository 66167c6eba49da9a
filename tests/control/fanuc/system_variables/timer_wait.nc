%
O0001
(rule: F 6.9 a loop that waits for the timer ends as soon as time goes on in it)
(expect: #1=3)
#1=0
#3001=0
WHILE[#3001LT300]DO1
G04P100
#1=#1+1
END1
M30
%
