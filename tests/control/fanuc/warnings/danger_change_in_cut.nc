%
O0001
(rule: technologist, wrong motion: the tool is changed below its last retract)
(expect: warning K5975 at 11:1)
(expect: warning K5973 at 12:1)
T1M6S1000M3
G43H1G0X0Y0Z50.
Z2.
G1Z-5.F100.
X50.
T2M6
G0Z50.
M30
%
