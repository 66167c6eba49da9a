%
O0001
(rule: F 1.5, 6.8: comments between the words of G66 and of a block under G66.1)
(expect: #100=1)
(expect: #101=2)
(expect: #102=7)
(expect: #103=8)
(expect: path X10)
G66 P9101 (DIA) A1. (LENGTH) B2.
X10.
G67
G66.1P9102
X7. (C) Y8.
G67
M30
O9101
#100=#1
#101=#2
M99
O9102
#102=#24
#103=#25
M99
%
