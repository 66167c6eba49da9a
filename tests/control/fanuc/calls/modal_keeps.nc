%
O0001
(rule: F 6.8 arguments of G66 are set once; what the macro changes stays)
(expect: #100=3)
G00
G66P2A1.
X10.
X20.
X30.
G67
M30
O0002
#100=#1
#1=#1+1
M99
%
