; rule: A 3.2 ORIPATH leads the tool along the path, as on SINUMERIK
; machine: five-axis
; expect: to X0 Y0 O0,0,1
; expect: to X0 Y0 O0.342020,0,0.939693 cone
; expect: to X50 Y0 O0.342020,0,0.939693 surface
; expect: to X50 Y0 O0,0.342020,0.939693 cone
; expect: to X50 Y50 O0,0.342020,0.939693 surface
S1000 M3
TRAORI
G1 X0 Y0 Z0 F1000
ORIPATH LEAD=20 TILT=0
X50
Y50
M30
