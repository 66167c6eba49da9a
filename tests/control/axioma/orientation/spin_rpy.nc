; rule: A 3 THETA counts as the third angle of the control's own Euler angles, Z Y' Z'', under ORIRPY as well
; machine: six-axis
; expect: to X10 A30 B35.26439 C45
; expect: to X20 A30 B35.26439 C45
; expect: to X30 A45 B35.26439 C45
S1000 M3
TRAORI
ORIEULER
G1 X10 A3=1 B3=1 C3=2 THETA=30 F500
ORIRPY
X20 THETA=30
X30 THETA=45
M30
