%
O0001
(rule: F 2.5 T only preselects, M06 changes; in one block or before it)
(expect: #1=1)
(expect: #2=2)
T1M06
#1=#4120
T2
#2=#4120
M06T1
M30
%
