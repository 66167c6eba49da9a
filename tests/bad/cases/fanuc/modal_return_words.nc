%
O0001
T1 M6
S1000 M3
G66 P2
G00 X10.
G67
M30
O0002
Y1. M99
%
(expect: 10:5 PS1093 DUPLICATE NC-WORD & M99: `M99` shares its block with words)
(exit: 3)
