%
O0001
(rule: F 2.3 a number has no exponent)
(expect: alarm PS0009 K5001 at 5:3)
X1EX3
M30
%
