%
O0001
(rule: F 6.10 behind PCLOS nothing is printed)
(expect: print [A])
(expect: alarm PS1143 K5487 at 9:1)
POPEN
DPRNT[A]
PCLOS
DPRNT[B]
M30
%
