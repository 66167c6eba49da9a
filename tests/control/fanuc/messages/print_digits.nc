%
O0001
(rule: F 6.10 at most eight digits)
(expect: alarm PS1143 K5486 at 6:8)
POPEN
DPRNT[X#1[54]]
PCLOS
M30
%
