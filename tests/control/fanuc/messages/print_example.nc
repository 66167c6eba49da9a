%
O0001
(rule: F 6.10 sign, digits that have no place are cut, no point without decimals)
(expect: print [X   128.474Y-   91.200T 23])
#2=128.47398
#5=-91.2
#30=123.456
POPEN
DPRNT[X#2[53]Y#5[53]T#30[20]]
PCLOS
M30
%
