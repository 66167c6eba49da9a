%
O0001
(rule: F 3.8 I and K together: PS0053)
(expect: alarm PS0053 K5317 at 7:1)
S1000M03
G00X40.Z0
G01Z-20.I-3.K2.F0.2
X0
M30
%
