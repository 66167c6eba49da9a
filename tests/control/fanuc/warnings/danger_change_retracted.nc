%
O0001
(rule: out of the cut at feed, or at rapid, and behind a cycle nothing is said of the change)
(expect: warning K5975 at 20:1)
T1M6S1000M3
G43H1G0X0Y0Z50.
Z2.
G1Z-5.F100.
Z2.
T2M6S1000M3
G43H2G0Z50.
G1Z-5.
G0Z50.
T3M6S1000M3
G43H3Z50.
G98G81X0Y0Z-5.R2.F100.
G80
T1M6S1000M3
G43H1Z2.G1Z-1.
T2M6
M30
%
