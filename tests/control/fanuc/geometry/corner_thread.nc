%
O0001
(rule: F 3.8 not beside a thread: PS0050)
(expect: alarm PS0050 K5319 at 6:1)
S1000M03
G33Z-20.F2.,C2.
G01Y30.
M30
%
