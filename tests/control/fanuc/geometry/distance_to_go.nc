%
O0001
(rule: F 6.5 #5181: nothing is left to go behind a block)
(expect: #1=0)
G00X5.
#1=#5181
M30
%
