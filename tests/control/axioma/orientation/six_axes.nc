; rule: A 2.4 and 4 with a third axis all three angles of the tool's body count
; machine: six-axis
; expect: to X1 C30 B40 A50
; expect: to X2 C30 B40 A70
S1000 M3
TRAORI
ORIAXES
ORIEULER
G1 X1 A2=30 B2=40 C2=50 F500
X2 A2=30 B2=40 C2=70
M30
