%
O00001
(rule: Haas G154 P1 to P99; G110 to G129 are the first twenty)
(expect: #100=7)
(expect: #101=8)
(expect: #102=2)
G154 P1
#100=#4012
G111
#101=#4012
G55
#102=#4012
M30
%
