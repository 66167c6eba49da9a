%
O0001
(rule: F 3.6 the start lies inside of the base circle: PS0242)
(expect: to X20 Y0)
(expect: alarm PS0242 K5489 at 8:1)
S1000M03
G01X20.Y0.F500.
G03.2X0.Y40.I-20.J0.R25.
M30
%
