%
O0001
(rule: F 6.10 DPRNT: text, * is a blank, #b[cd] has c digits and d decimals)
(expect: print [X   12.500 END])
#1=12.5
POPEN
DPRNT[X#1[43]*END]
PCLOS
M30
%
