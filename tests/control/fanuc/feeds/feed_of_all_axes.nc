%
O0001
(rule: F 3.2 F is the speed of all axes, and stays what is programmed)
(machine: rotary-a)
(expect: to X20 A40 line F300)
(expect: to X20 A80 line F300)
T1 M6
S100 M3
G94 G1 X20. A40. F300.
A80.
M30
%
