%
O0001
(rule: F 6.4 a main program that ends with M99 begins again: one pass, and a warning)
(expect: warning K5900 at 11:1)
(expect: #500=1)
(expect: path x10f100 X0)
T1M06S100M03
G01X10.F100
#500=#500+1
G00X0
M99
%
