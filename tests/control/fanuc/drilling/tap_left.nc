%
O0001
(rule: F 5.3 G74 the left thread, G95: F is the pitch)
M4S500
G00Z20.
M29S500
G95G74X10.Z-10.R2.F1.
G80
M30
%
