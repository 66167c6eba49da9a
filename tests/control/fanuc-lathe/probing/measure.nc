%
O0001
(rule: F 2.3 G36 X and G37 Z: the tool goes to the sensor; the offset that T has called stays)
(expect: warning K5574 at 8:1)
(expect: path X100Z50 X40 Z10)
T0101
G00X100.Z50.
G36X40.
G37Z10.
M30
%
