%
O0001
(rule: F 2.3 G25, G26: passed over, said once)
(expect: to X0.5)
G25
G26
G26P3000Q15R30
G00X1.
M30
%
