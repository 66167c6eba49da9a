%
O0001
(rule: F 12 GOTO0: PS1128)
(expect: alarm PS1128 K5430 at 5:5)
GOTO0
M30
%
