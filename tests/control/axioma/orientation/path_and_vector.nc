; rule: S 7.3 a vector under ORIPATH: 14116
; machine: five-axis
; expect: alarm 14116 K5617 at 7:8
S1000 M3
TRAORI
ORIPATH
G1 X20 A3=1 C3=1 F1000
M30
