%
O0001
(rule: F 3.1 X and U are diameters, I and R are radii)
(expect: to X10 Z0)
(expect: to X15)
(expect: to X20 Z-5 ccw)
(expect: to X25 Z-10 cw I25 K-5)
G98F100M3S500
G00X20.Z0
U10.
G03X40.Z-5.R5.
G02X50.Z-10.I5.K0
M30
%
