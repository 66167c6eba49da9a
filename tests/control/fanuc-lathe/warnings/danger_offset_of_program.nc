%
O0001
(rule: technologist, wrong motion: the offset of another tool that the program itself has called so)
(machine: lathe)
(expect: warning K5240 at 9:1)
(expect: warning K5979 at 12:1)
G99S1000M3
T0404
G0X50.Z2.
G0X80.Z10.
T0204
G0X50.Z2.
G0X80.Z10.
M30
%
