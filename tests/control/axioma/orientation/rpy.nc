; rule: A 3 angles of roll, pitch and yaw about Z, Y', X'', as on SINUMERIK
; machine: five-axis
; expect: to X1 O0.739199,0.280330,0.612372
; expect: to X2 O0.219846,-0.262003,0.939693
S1000 M3
TRAORI
ORIRPY
G1 X1 A2=30 B2=45 C2=60 F500
X2 A2=20 B2=0 C2=40
M30
