%
O0001
(rule: F 6.5 #5201: external offset)
(expect: to X7)
(expect: to X19 Y20)
(expect: #1=9)
G54
#5201=7
G00X0.
#5201=#5201+2
G55X0.Y0.
#1=#5201
M30
%
