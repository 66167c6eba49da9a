%
O0001
(rule: a length stays over the change of the tool: H1 acts with tool 2 as well)
(expect: warning K5973 at 8:1)
T1M6S1000M3
G43H1Z100.
T2M6S1000M3
G0X10.Z50.
G43H2Z20.
M30
%
