%
O0001
(rule: F 4.3 D0 says that there is no radius: no word about it)
(expect: warning K5241 at 7:1)
(expect: path x10y5f100)
T1M06
M59
S100M03
G01G41D0X10.Y5.F100
M30
%
