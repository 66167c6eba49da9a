%
O0001
(rule: F 6.7 1 to 3: PS0126)
(expect: alarm PS0126 K5433 at 5:14)
WHILE[1EQ1]DO4
END4
M30
%
