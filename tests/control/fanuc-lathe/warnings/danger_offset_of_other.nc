%
O0001
(rule: technologist, wrong motion: the offset of another tool of the machine; a further one of its own is only not known)
(machine: lathe)
(expect: warning K5979 at 12:1)
(expect: warning K5240 at 15:1)
G99S1000M3
T0303
G0X50.Z2.
G0X80.Z10.
T0203
G0X50.Z2.
G0X80.Z10.
T0212
G0X50.Z2.
M30
%
