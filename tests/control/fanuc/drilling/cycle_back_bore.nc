%
O0001
(rule: F 5.2 G87: up to Z, dwell, orientation, shift: no way back from the face)
(expect: path Z20 X30 X31 Z-15 X30 z-2f60 X31 Z20 X30)
G00X0Y0Z20.S1000M3
G98G87X30.Y0Z-2.R-15.Q1.P100F60
G80
M30
%
