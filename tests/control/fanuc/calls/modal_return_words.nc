%
O0001
(rule: F 6.8 PS1093: words in the last block of a modal macro)
(expect: alarm PS1093 K5475 at 11:4)
(expect: called 8:1)
G00
G66P2
X10.
M30
O0002
Y1.M99
%
