%
O0001
(rule: F 6.10 BPRNT: of each value four bytes, the highest first: 1094861636 is 41424344 hexadecimal)
(expect: print [XABCD])
POPEN
#1=109486.1636
BPRNT[X#1[4]]
PCLOS
M30
%
