%
O0001
(rule: F 2.2 G25, G26: passed over, said once)
(expect: to X1)
G25
G26
G26P3000Q15R30
G00X1.
#1=#4019
M30
%
