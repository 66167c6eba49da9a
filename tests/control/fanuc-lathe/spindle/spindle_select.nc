%
O0001
(rule: F 4 of several spindles P selects one; which is which the builder sets, so it is said)
(machine: lathe)
(expect: #1=1000)
(expect: #2=1500)
(expect: warning K5247 at 10:9)
(expect: path X20Z2 z-5f0.2)
T0101
G50S3000P11
G97S1000P11M03
#1=#4119
M03P2
G97S1500P3
#2=#4119
G00X20.Z2.
G01Z-5.F0.2
M05P11
M30
%
