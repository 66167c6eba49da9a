%
O00001
(rule: Haas #4001 and on: the codes that are active)
(expect: #100=1)
(expect: #101=18)
(expect: #102=91)
G01 G18 G91 F100.
#100=#4001
#101=#4002
#102=#4003
M30
%
