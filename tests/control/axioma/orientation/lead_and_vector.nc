; rule: S 7.3 LEAD and a vector exclude each other: 14116
; machine: five-axis
; expect: alarm 14116 K5617 at 6:15
S1000 M3
TRAORI
G1 X10 LEAD=0 A3=1 C3=1 F1000
M30
