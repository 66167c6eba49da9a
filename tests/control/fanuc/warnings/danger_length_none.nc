%
O0001
(rule: the length of the tool that is in, no length, and the home position before the next one: nothing is said)
(expect: warning K5970 at 14:7)
T1M6S1000M3
G43H1Z100.
G49Z200.
T2M6S1000M3
G91G28Z0
G90X10.
G43H2Z20.
T3M6
S1000M3G95
G1X20.F6.
M30
%
