%
O0001
(rule: F 6.1 macro and NC words in one block: PS0127)
(expect: alarm PS0127 K5409 at 5:4)
N5 #1=1 G01 X1.
M30
%
