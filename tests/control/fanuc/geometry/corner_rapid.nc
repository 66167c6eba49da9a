%
O0001
(rule: F 3.8 G00 follows: PS0052)
(expect: alarm PS0052 K5316 at 5:1)
G01X40.,C2.F200.
G00Y30.
M30
%
