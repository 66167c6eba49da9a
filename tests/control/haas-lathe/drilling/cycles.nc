%
O00001
(rule: Haas lathe: drilling, boring, a thread with its start; L repeats)
(machine: lathe)
(expect: path X20Z35 Z32 z27f0.1 Z35 Z32 z26 z32 Z35)
G55
T0101
G97 S1000 M03
G00 X0. Z5.
G81 Z-3. R2. F0.1 Q1.
G89 Z-4. P0.5
G80
M30
%
