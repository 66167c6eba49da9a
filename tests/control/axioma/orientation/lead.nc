; rule: A 3 lead and tilt against the tangent and the normal at the end of the block, whatever the way there is
; machine: five-axis
; expect: to X50 O0.342020,0,0.939693 cone
; expect: to X60 Y10 ccw O0,0.342020,0.939693 cone
; expect: to X60 Y20 O0,0.342020,0.939693
S1000 M3
TRAORI
G1 X50 LEAD=20 F500
G3 X60 Y10 CR=10 LEAD=20
G1 Y20 LEAD=20
M30
