; rule: A 3 a tilt leans the tool aside of the direction of travel
; machine: five-axis
; expect: to X50 O0,-0.173648,0.984808
S1000 M3
TRAORI
G1 X50 TILT=10 LEAD=0 F500
M30
