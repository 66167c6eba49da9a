%
O0001
(rule: F 6.5 #3001: a rapid takes as long as its slowest axis)
(expect: #1=200)
G00X100.Y50.
#1=#3001
M30
%
