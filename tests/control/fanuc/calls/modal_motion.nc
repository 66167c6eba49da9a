%
O0001
(rule: F 6.8 G66: after each block that moves, not in its own and not after others)
(expect: #100=2)
(expect: to X10)
(expect: to X10 Y5)
(expect: to X0)
G00
G66P2A1.
M08
X10.
Y5.
G67
X0
M30
O0002
#100=#100+#1
M99
%
