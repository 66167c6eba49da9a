%
O0001
(rule: F 11 PS0125: the condition without GOTO or THEN)
(expect: alarm PS0125 K5402 at 5:9)
IF[1EQ1]X5.
M30
%
