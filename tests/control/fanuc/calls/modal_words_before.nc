%
O0001
(rule: F 6.5 M, N and O of the block before; B and E that nobody said)
(expect: #1=8)
(expect: #2=50)
(expect: #3=1)
(expect: #104=9100)
(expect: #5=0)
(expect: #6=0)
(expect: #7=6)
S1000M3
N50M8
#1=#4113
#2=#4114
#3=#4115
G65P9100
#5=#4102
#6=#4108
M9T1M6
#7=#4313
M30
O9100
#104=#4115
M99
%
