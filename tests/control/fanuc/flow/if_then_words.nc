%
O0001
(rule: F 6.7 words behind THEN: PS0127)
(expect: alarm PS0127 K5409 at 5:13)
IF[1EQ1]THENG00X1.
M30
%
