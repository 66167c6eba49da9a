%
O0001
(rule: F 6.2 reading a variable that only acts: PS1115)
(expect: alarm PS1115 K5412 at 5:4)
#1=#3000
M30
%
