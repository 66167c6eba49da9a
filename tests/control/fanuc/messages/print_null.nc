%
O0001
(rule: F 6.10 a vacant variable prints nothing)
(expect: print [A=B])
POPEN
DPRNT[A=#0[30]B]
PCLOS
M30
%
