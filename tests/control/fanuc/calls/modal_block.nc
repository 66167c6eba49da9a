%
O0001
(rule: F 6.8 G66.1: blocks are arguments, G #10 L #12 N #14 P #16)
(expect: #100=1)
(expect: #101=5)
(expect: #102=7)
(expect: #103=2)
(expect: #104=3)
(expect: #105=100)
G66.1P2
N100G01X5.Y7.L2P3
G67
M30
O0002
#100=#10
#101=#24
#102=#25
#103=#12
#104=#16
#105=#14
M99
%
