%
O00001
(rule: Haas ATAN of two parts: from -180 to 180)
(expect: #100=-135)
(expect: #101=135)
#100=ATAN[-1]/[-1]
#101=ATAN[1]/[-1]
M30
%
