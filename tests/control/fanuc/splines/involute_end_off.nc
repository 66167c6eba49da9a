%
O0001
(rule: F 3.6 the end lies beside the involute: PS0243)
(expect: to X20 Y0)
(expect: alarm PS0243 K5490 at 8:1)
S1000M03
G01X20.Y0.F500.
G03.2X-18.761Y33.I-20.J0.R8.
M30
%
