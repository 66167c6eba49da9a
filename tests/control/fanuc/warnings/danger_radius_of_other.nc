%
O0001
(rule: D of another tool of the machine is its radius; D of none is the shop own numbering)
(expect: warning K5977 at 10:8)
(expect: warning K5271 at 13:1)
T1M6
S1000M3
G43H1Z10.
G1Z-1.F100.
G41X10.D2
X20.
G40X30.
G41X40.D31
X50.
G40X60.
M30
%
