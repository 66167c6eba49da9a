%
O0001
(rule: F 6.7 brackets are mandatory: PS1131)
(expect: alarm PS1131 K5403 at 5:3)
IF#1EQ1GOTO10
M30
%
