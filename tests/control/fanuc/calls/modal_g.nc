%
O0001
(rule: F 6.5 #4001 and following: the modal G codes)
(expect: #1=0)
(expect: #2=18)
(expect: #3=91)
(expect: #4=21)
(expect: #5=2)
(expect: #6=100)
(expect: #7=94)
(expect: #8=40)
(expect: #9=54)
G91G18
#1=#4001
#2=#4002
#3=#4003
#4=#4006
#7=#4005
#8=#4007
#9=#4014
G90G17G02X0Y0I5.F100.
#5=#4001
#6=#4109
M30
%
