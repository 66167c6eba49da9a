; rule: A 3 its Euler angles act from the start, before ORIEULER is written
; machine: five-axis
; expect: to X10 O0.612372,0.353553,0.707107
S1000 M3
TRAORI
G1 X10 A2=30 B2=45 F1000
M30
