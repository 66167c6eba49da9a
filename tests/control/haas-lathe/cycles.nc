%
O00001
(rule: Haas lathe: drilling, boring, a thread with its start; L repeats)
(machine: lathe)
(expect: path Z5 Z2 z-3f0.1 Z5 Z2 z-4 z2 Z5)
G55
T0101
G97 S1000 M03
G00 X0. Z5.
G81 Z-3. R2. F0.1 Q1.
G89 Z-4. P0.5
G80
M30
%
