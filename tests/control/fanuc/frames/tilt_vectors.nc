%
O0001
(rule: F 4.8 G68.2 P3: origin and X, then Z)
(expect: to X11 Y0 Z8)
G68.2P3Q1X1.Y2.Z3.I2.J0K0
G68.2P3Q2I0J-1.K0
G00X10.Y5.Z2.
M30
%
