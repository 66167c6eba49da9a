%
O0001
(rule: F 6.5 #4201 and #4309: of the block that is executed)
(expect: #1=1)
(expect: #2=90)
(expect: #3=120)
(expect: #4=17)
G01X1.F120
#1=#4201
#2=#4203
#3=#4309
#4=#4202
M30
%
