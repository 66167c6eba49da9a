%
O0001
(rule: F 12 ATAN over four quadrants)
(expect: #1=45)
(expect: #2=315)
(expect: #3=135)
(expect: #4=225)
(expect: #5=45)
(expect: #6=-45)
(expect: #7=9)
#1=ATAN[1]/[1]
#2=ATAN[-1]/[1]
#3=ATAN[1]/[-1]
#4=ATAN[-1]/[-1]
#5=ATAN[1,1]
#6=ATAN[-1]
#7=[ATAN[1]]/5
M30
%
