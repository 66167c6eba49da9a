%
O0001
(rule: F 5.1: another plane under a cycle: along the new drilling axis the initial level is where the tool stands)
(expect: path Y12 Z20 X10 Z5 z-10f500 Z20 X20 Y5 y-10 Y12)
G0Y12.S100M3
G0Z20.
G81X10.Z-10.R5.F500
G18X20.
M30
%
