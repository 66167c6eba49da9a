%
O0001
(rule: F 3.6 R beside G31 has no meaning: told)
(expect: warning K5226 at 6:10)
(expect: warning K5951 at 6:1)
G31X10.  R5.F100
M30
%
