%
O0001
(rule: F 3.8 one per block: PS0053)
(expect: alarm PS0053 K5317 at 5:12)
G01X40.,C2.,R2.F200.
G01Y30.
M30
%
