%
O0001
(rule: technologist, wrong motion: F0.2 under G94 was meant for a turn; said once of each feed)
(expect: warning K5971 at 8:10)
(expect: warning K5971 at 10:5)
T1M6S1000M3
G43H1G0Z5.
G94G1Z-1.F0.2
X10.
X20.F0.3
X30.F0.2
M30
%
