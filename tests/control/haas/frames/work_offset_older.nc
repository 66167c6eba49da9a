%
O00001
(rule: Haas G154 P1 to P99; G110 to G129 are the first twenty)
(expect: #100=154)
(expect: #101=111)
(expect: #102=55)
G154 P1
#100=#4012
G111
#101=#4012
G55
#102=#4012
M30
%
