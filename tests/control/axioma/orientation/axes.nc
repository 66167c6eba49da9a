; rule: A 3.2 axis interpolation is basic: the axes go in proportion; ORIVECT: along the great circle
; machine: five-axis
; expect: to X10 A45 C90 axes
; expect: to X20 A45 C180 cone
S1000 M3
TRAORI
ORIAXES
G1 X10 A3=1 C3=1 F500
ORIVECT
X20 B3=1 C3=1
M30
