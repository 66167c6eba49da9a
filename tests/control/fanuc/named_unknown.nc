%
O0001
(rule: F 6.6 the inputs of the machine nobody knows here)
(expect: alarm  K5018 at 5:5)
#1=[#_UI[5]]
M30
%
