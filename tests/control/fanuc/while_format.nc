%
O0001
(rule: F 11 PS0125: WHILE without DO)
(expect: alarm PS0125 K5402 at 5:12)
WHILE[1EQ1]
M30
%
