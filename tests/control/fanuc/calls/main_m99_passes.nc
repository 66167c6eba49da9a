%
O0001
(rule: F 6.4 a main program that ends with M99 begins again: as often as was asked for)
(passes: 3)
(expect: #500=3)
(expect: path x10f100 X0 x10 X0 x10 X0)
T1M06S100M03
G01X10.F100
#500=#500+1
G00X0
M99
%
