%
O0001
(rule: F 6.5 #5061: where the skip ended, at the end of the way if no signal came)
(expect: #1=12)
(expect: #2=0)
(expect: to X50)
G54G31X12.F100
G00X50.
#1=#5061
#2=#5062
M30
%
