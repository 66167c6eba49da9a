; rule: A 2.4 a machine without addresses of rotary axes has no transformation: SINUMERIK's alarm
; expect: to X10
; expect: alarm 14100 K5600 at 5:1
G0 X10
TRAORI
M30
