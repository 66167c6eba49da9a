%
O1
#1=SQRT[-1]
M30
%
(expect: 3:4 PS0119 ARGUMENT VALUE OUT OF RANGE: SQRT has no value at -1)
(exit: 3)
