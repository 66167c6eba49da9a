%
O0001
(rule: F 3.5 the sign of R says which way the next block goes)
(machine: lathe)
(expect: fix `R-2.` goes on the other way, `,R2.` whichever way the next block goes)
(expect: alarm PS0051 K5906 at 10:1)
T0101
G99G97S500M03F0.1
G00X100.Z2.
G01X50.R2.
Z-20.
M30
%
