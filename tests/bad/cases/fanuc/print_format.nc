%
O0001
POPEN
DPRNT[X#100[5]]
PCLOS
M30
%
(expect: 4:8 PS1143 ILLEGAL FORMAT IN BPRNT/DPRNT: `#100[5]` is no format of a value that is printed)
(exit: 3)
