%
O0001
(rule: F 6.8 a negative number: as G66)
(expect: #100=6)
G00
G101A3.
X1.
X2.
G67
X3.
M30
O9011
#100=#100+#1
M99
%
