%
O0001
(rule: F 6.5 inputs: not known here, never 0)
(expect: alarm  K5018 at 5:4)
#1=#1000
M30
%
