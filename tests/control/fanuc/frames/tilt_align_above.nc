%
O0001
(rule: F 4.8 G53.6 R: a point above the tip stays on the part while the axes turn; which way is unsure)
(machine: five-axis)
(expect: #2=5)
(expect: #3=-1.34)
(expect: to X0 Y0 Z0)
(expect: to X0 Y0 Z10 A30 axes O0,-0.5,0.866025)
T1M06
S1000M03
G00X0Y0Z0
G68.2X0Y0Z0I0J30.K0
G53.6H1R10.
#2=#5002
#3=#5003
G69
M30
%
