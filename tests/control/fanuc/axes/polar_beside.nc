%
O0001
(rule: F 3.6 G12.1: the tool stands at the centre of C)
(expect: alarm PS0145 K5540 at 7:1)
S1000 M3
G00 X40. Y3. C0
G12.1
M30
%
