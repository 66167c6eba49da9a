%
O0001
(rule: F 6.4 computed arc words)
(expect: to X10 Y0)
(expect: to X0 Y10)
#1=10
S1000M03
G17G90G00X#1Y0
G03X0Y#1R#1F100.
M30
%
