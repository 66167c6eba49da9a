; rule: A 3, S 7.4: lead and tilt are angles to the normal at the end of the block; that of its start says nothing
; machine: mixed-cb
; expect: to X20 Y0 O0.087156,-0.445512,0.891024
; expect: to X20 Y20 O0.445512,0.087156,0.891024
S1000 M3
TRAORI
G1 X20 Y0 LEAD=5 TILT=0 B5=-0.5 C5=1 F500
G1 X20 Y20 A5=0.5 C5=1
M30
