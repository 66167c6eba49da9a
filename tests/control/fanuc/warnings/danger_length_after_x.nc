%
O0001
(rule: technologist, wrong motion: the length of another tool, where the first motion behind the change is none along it)
(expect: warning K5973 at 12:1)
T1M6S1000M3
G43H1G0X0Y0Z50.
G1Z-1.F100.
G0Z50.
T2M6
M3
G0X10.
Z2.
G1Z-1.
G0Z50.
M30
%
