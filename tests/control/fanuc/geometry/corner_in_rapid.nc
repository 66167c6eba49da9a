%
O0001
(rule: F 3.8 not beside G00: PS0052)
(expect: alarm PS0052 K5316 at 5:1)
G00X40.,C2.
G01Y30.F100.
M30
%
