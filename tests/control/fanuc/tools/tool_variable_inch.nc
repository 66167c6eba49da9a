%
O0001
(rule: F 6.5 offsets are in the units of the text)
(expect: #1=1)
(expect: #2=2)
#11007=25.4
G20
#1=#11007
#11007=2
#2=#11007
M30
%
