%
O0001
(rule: F 6.5 #3011 and #3012: date and time)
(expect: #1=20261122)
(expect: #2=130509)
(expect: #3=130610)
#1=#3011
#2=#3012
G04X61.
#3=#3012
M30
%
