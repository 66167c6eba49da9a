%
O0001
(rule: F 5.3 PS0206: another plane behind M29)
(expect: alarm PS0206 K5532 at 7:1)
S500M3
M29S500
G18
G84X1.Z-5.R2.F100
M30
%
