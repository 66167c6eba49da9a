%
O0001
(rule: F 3.6 G02.2 without the centre of its base circle: PS0241)
(expect: to X20 Y0)
(expect: alarm PS0241 K5494 at 8:1)
S1000M03
G01X20.Y0.F500.
G03.2X-18.761Y32.495R8.
M30
%
