%
O0001
(rule: F 3.6 R beside G31 has no meaning: told)
(expect: warning K5226 at 5:10)
G31X10.  R5.F100
M30
%
