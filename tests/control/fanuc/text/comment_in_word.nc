%
O0001
(rule: F 1.5 no comment inside a word)
(expect: alarm PS0005 K5003 at 5:1)
X(A)1.
M30
%
