%
O0001
#100=1.
DPRNT[X#100[53]]
M30
%
(expect: 4:1 PS1143 ILLEGAL FORMAT IN BPRNT/DPRNT: the printer is not open)
(exit: 3)
