%
O0001
(rule: F 6.1 an undefined word: PS0199)
(expect: alarm PS0199 K5407 at 5:4)
#1=FOO[1]
M30
%
