; rule: A 3 LEAD and TILT stay until they are changed, also if they stand in a block of their own
; machine: five-axis
; expect: to X10 O0,0,1
; expect: to X20 O0.342020,0,0.939693 cone
; expect: to X20 Y10 O0,0.342020,0.939693 cone
S1000 M3
TRAORI
G1 X10 F1000
LEAD=20
X20
Y10
M30
