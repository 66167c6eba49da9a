%
O0001
(rule: F 6.7 PS1124: WHILE without DO)
(expect: alarm PS1124 K5496 at 5:12)
WHILE[1EQ1]
M30
%
