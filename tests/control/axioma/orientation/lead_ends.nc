; rule: A 3 LEAD stays until a block says another direction of the tool
; machine: five-axis
; expect: to X20 O0.342020,0,0.939693 cone
; expect: to X30 O0,0,1 cone
; expect: to X30 Y20 O0,0,1
S1000 M3
TRAORI
G1 X20 LEAD=20 F1000
X30 A3=0 B3=0 C3=1
Y20
M30
