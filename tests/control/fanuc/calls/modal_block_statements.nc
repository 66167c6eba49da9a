%
O0001
(rule: F 6.8 G66.1: macro statements are executed as ever)
(expect: #100=2)
(expect: #101=9)
G66.1P2
#101=9
X5.
X6.
G67
M30
O0002
#100=#100+1
M99
%
