%
O0001
(rule: F 6.7 PS0124)
(expect: alarm PS0124 K5434 at 5:1)
WHILE[1EQ1]DO1
#1=1
M30
%
