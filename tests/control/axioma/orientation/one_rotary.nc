; rule: A 2.4 one rotary axis: the transformation acts, a block with a vector is aborted, whatever it is
; machine: rotary-a
; expect: to X10 A20
; expect: alarm 14112 K5606 at 8:1
S1000 M3
TRAORI
G1 X10 A=20 F500
X20 B3=1 C3=1
M30
