%
O0001
(rule: F 3.1 I and J do not care for G91)
(expect: to X20 cw I10)
(expect: to X40 cw I30)
G91G02X20.I10.F100
G90G02X40.I10.
M30
%
