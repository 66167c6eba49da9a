%
O0001
(rule: F 3.4 G52, G92 and G10 L2 shift rotary axes, too)
(machine: rotary-a)
(expect: to X0 Y0 A15)
(expect: to A17)
(expect: to X5 A15)
(expect: #1=0)
T1 M6
G52 A10.
G90 G0 X0 Y0 A5.
G92 A0.
#1=#5044
G0 A2.
G92 A17.
G52 X5. A-2.
G0 X0 A17.
M30
%
