; rule: A 3 and 3.1 a head Z, Y' has the angles as its places, and a second solution, the nearer of which is taken
; machine: head-cb
; expect: to X1 B45 C30 O0.612372,0.353553,0.707107
; expect: to X2 B-45 C-150
; expect: to X3 B-45 C-150 O0.612372,0.353553,0.707107
; expect: to X4 B-30 C-120
S1000 M3
TRAORI
ORIAXES
ORIEULER
G1 X1 A2=30 B2=45 F500
X2 B=-45 C=-150
X3 A2=30 B2=45
X4 A2=60 B2=30
M30
