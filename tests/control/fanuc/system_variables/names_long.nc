%
O0001
(rule: F 6.6 SETVN: eight characters at most)
(expect: alarm PS1142 K5581 at 5:1)
SETVN 500[CLEARANCE]
M30
%
