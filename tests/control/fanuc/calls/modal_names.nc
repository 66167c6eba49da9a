%
O0001
(rule: F 6.6 the same by their names, and of the block that is executed)
(expect: #1=8)
(expect: #2=1)
(expect: #3=0)
(expect: #4=0)
(expect: #5=8)
(expect: #6=1)
(expect: #7=0)
(expect: #8=0)
(expect: #9=67)
(expect: #10=0)
(expect: #11=0)
M8
#1=[#_BUFM]
#2=[#_BUFO]
#3=[#_BUFB]
#4=[#_BUFE]
#5=[#_ACTM]
#6=[#_ACTO]
#7=[#_ACTB]
#8=[#_ACTE]
#9=#4212
#10=[#_ABSKP[1]]
#11=#100151
M30
%
