; rule: A 1 TRAORI is a word of the control; Kadr does not execute the transformation
; expect: to X10
; expect: alarm  K5018 at 5:1
G0 X10
TRAORI
M30
