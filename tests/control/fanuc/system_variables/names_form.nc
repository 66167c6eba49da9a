%
O0001
(rule: F 6.6 SETVN without brackets)
(expect: alarm PS1139 K5579 at 5:1)
SETVN 500
M30
%
