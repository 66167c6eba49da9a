%
O0001
(rule: F 6.5: a lathe has neither #4107 nor #4111)
(expect: alarm PS0115 K5410 at 5:4)
#1=#4111
M30
%
