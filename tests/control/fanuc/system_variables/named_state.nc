%
O0001
(rule: F 6.6 [#_CLOCK1], [#_CNTL1], [#_PRTSA], [#_BUFF], [#_ACTG[1]])
(expect: #1=100)
(expect: #2=1)
(expect: #3=7)
(expect: #4=80)
(expect: #5=1)
(expect: #6=20261122)
G04P100
#1=[#_CLOCK1]
[#_CNTL1]=1
#2=#3003
[#_PRTSA]=7
#3=#3901
G01X0.F80
#4=[#_BUFF]
#5=[#_ACTG[1]]
#6=[#_DATE]
M30
%
