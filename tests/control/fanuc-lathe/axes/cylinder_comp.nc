%
O0001
(rule: F 3.6 G07.1: G41 and G42 on the developed cylinder)
(machine: driven)
(expect: to X20 Z0 C0 rapid)
(expect: to Y-5 Z-20 C-14.323945)
(expect: to Y36.415927 Z-20 C104.323945)
(expect: to Y31.415927 Z0 C90)
G10 P10002 R5. Q0
G98 G97 S1000 M3
T0202
G00 X40. Z0 C0
G18
G07.1 C20.
G41 G01 Z-15. F100
C90.
G40 Z0
G07.1 C0
M30
%
