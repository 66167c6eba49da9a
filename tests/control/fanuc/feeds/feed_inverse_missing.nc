%
O0001
(rule: F 2.5 G93 wants F in each block: PS1202)
(expect: alarm PS1202 K5212 at 8:1)
(expect: to X10)
M3S1000
G93G01X10.F2.
X20.
M30
%
