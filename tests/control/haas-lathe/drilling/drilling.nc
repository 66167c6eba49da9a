%
O00001
(rule: Haas lathe: R and Z of a drilling cycle are coordinates, P of a dwell has its point)
(machine: lathe)
(expect: path Z5 Z2 z-3f0.1 Z2 Z-2 z-6 Z5 Z50)
(expect: dwell 1)
T0101
G97 S1000. M03
G154 P1
G00 X0. Z5.
G83 Z-6. R2. Q5. F0.1
G80
G04 P1.
G00 Z50.
M30
%
