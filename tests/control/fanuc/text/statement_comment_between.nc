%
O0001
(rule: F 1.5: comments between the words of calls and of macro statements)
(expect: #100=2)
(expect: #101=2)
(expect: #102=1)
(expect: #103=1)
(expect: print [A 2])
M98 (SUB) P12 (TWICE) L2
IF (C) [#100 EQ 2] (C) THEN (C) #102=1
IF [#100 EQ 2] (C) GOTO 5
#103=9
N5 (C) #103=1
WHILE (C) [#101 LT 2] (C) DO1
#101=#101+1
END1 (C)
POPEN
DPRNT (C) [A#101[10]]
PCLOS
M98 (SUB) P13
M30
O0012
#100=#100+1
M99 (C)
O0013
M99 (BACK)
%
