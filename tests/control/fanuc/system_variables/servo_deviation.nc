%
O0001
(rule: F 6.5 #5101: what the drives do only the machine tells; 0, and told)
(expect: warning K5950 at 6:4)
(expect: #1=0)
#1=#5101
M30
%
