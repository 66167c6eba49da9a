%
O0001
(rule: F 6.10 BPRNT writes bytes; Kadr prints text alone)
(expect: alarm  K5018 at 6:1)
POPEN
BPRNT[X#1[3]]
PCLOS
M30
%
