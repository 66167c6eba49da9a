%
O0001
#1=5
#50=#1
M30
%
(expect: 4:1 PS0115 there is no variable #50)
(exit: 3)
