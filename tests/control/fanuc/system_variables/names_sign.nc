%
O0001
(rule: F 6.6 SETVN: a name begins with a letter)
(expect: alarm PS1141 K5580 at 5:1)
SETVN 500[2ND]
M30
%
