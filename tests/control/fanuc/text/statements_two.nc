%
O0001
(rule: F 6.1 one macro statement a block)
(expect: alarm PS0127 K5409 at 5:6)
#1=1 #2=2
M30
%
