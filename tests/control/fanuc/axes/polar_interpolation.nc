%
O0001
(rule: F 3.6 G12.1 on a machining centre with a rotary table C: X is no diameter)
(expect: to X40 C0 rapid)
(expect: to X0 Y40 C90)
(expect: to X-40 Y0 cw I0 J0)
(expect: to X50 rapid)
S1000 M3
G00 X40. Y0 C0
G12.1
G01 X0 C40. F200
G02 X-40. C0 I0 J-40.
G13.1
G00 X50.
M30
%
