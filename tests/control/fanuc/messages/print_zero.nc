%
O0001
(rule: F 6.10 zero and small numbers)
(expect: print [A     0.000])
(expect: print [B     0.010])
(expect: print [C   0])
(expect: print [D-   0.50])
#100=.01
#101=-.5
POPEN
#110=0
DPRNT[A#110[53]]
DPRNT[B#100[53]]
DPRNT[C#110[30]]
DPRNT[D#101[42]]
PCLOS
M30
%
