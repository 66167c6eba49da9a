%
O0001
(rule: F 6.7 ranges do not cross)
(expect: alarm PS0124 K5434 at 6:1)
(expect: called 8:1)
WHILE[1EQ1]DO1
WHILE[1EQ1]DO2
END1
END2
M30
%
