%
O0001
(rule: technologist, wrong motion: the first cut of a tool whose length nobody calls, where the program calls those of others)
(expect: warning K5980 at 13:1)
T1M6S1000M3
G43H1G0X0Y0Z50.
G1Z-5.F100.
G0Z50.
G49
T2M6
M3
G0Z2.
G1Z-5.
G0Z50.
T3M6
M3
G43H3G0Z50.
G1Z2.
G0Z50.
M30
%
