; rule: A 3 Euler angles about Z, Y', Z'': SINUMERIK's numbers give another direction
; machine: five-axis
; expect: to X1 O0.612372,0.353553,0.707107
; expect: to X2 O0.707107,0,0.707107
; expect: to X3 O0,0,1
; expect: to X4 O0.709406,-0.496732,0.5
S1000 M3
TRAORI
ORIEULER
G1 X1 A2=30 B2=45 C2=60 F500
X2 A2=0 B2=45 C2=0
X3 A2=20 B2=0 C2=40
X4 A2=-35 B2=60 C2=15
M30
