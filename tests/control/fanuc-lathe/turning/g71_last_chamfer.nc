%
O0001
(rule: F 5.6 PS0069: chamfer in the last block of the shape)
(expect: path X80Z2)
(expect: alarm PS0069 K5782 at 12:5)
G99 G97 S500 M03
G00 X80. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.2
N10 G00 X50.
G01 Z-5. F0.1
N20 X62. K-1.
G00 X70.
M30
%
