%
O0001
(rule: F 12 the same number inside: illegal)
(expect: alarm PS0126 K5433 at 7:1)
(expect: called 6:1)
WHILE[1EQ1]DO1
WHILE[1EQ1]DO1
END1
END1
M30
%
