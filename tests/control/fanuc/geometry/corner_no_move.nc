%
O0001
(rule: F 3.8 no move follows: PS0051)
(expect: alarm PS0051 K5312 at 5:1)
G01X40.,C2.F200.
M08
Y30.
M30
%
