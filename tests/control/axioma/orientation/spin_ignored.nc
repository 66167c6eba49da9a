; rule: A 2.4 without a third axis the angle of the tool's own rotation has no influence
; machine: five-axis
; expect: warning K5630 at 9:7
; expect: to X1 A45 C90
; expect: to X2 A45 C90
S1000 M3
TRAORI
G1 X1 A3=1 C3=1 F500
G1 X2 THETA=30
M30
