%
O0001
(rule: F 11 PS1143 a format has two digits)
(expect: alarm PS1143 K5486 at 6:8)
POPEN
DPRNT[X#1[5]]
PCLOS
M30
%
