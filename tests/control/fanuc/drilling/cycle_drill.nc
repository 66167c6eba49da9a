%
O0001
(rule: F 5.2 G81, G82 with its dwell, each block with a place again)
(expect: path Z20 X10 Z2 z-10f100 Z20 Y5 Z2 z-10 Z20 X20Y0 Z2 z-10f200 Z20)
M3S1000
G00X0Y0Z20.
G98G81X10.Y0Z-10.R2.F100
Y5.
F200
G82X20.Y0P500
G80
M30
%
