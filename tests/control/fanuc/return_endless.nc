%
O0001
(rule: F 6.8 M99 in the main program: an endless loop without blocks)
(expect: alarm  K5439 at 6:1)
#1=1
M99
%
