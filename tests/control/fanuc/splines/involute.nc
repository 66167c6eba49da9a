%
O0001
(rule: F 3.6 G02.2: I J centre of the base circle, R its radius)
(expect: to X20 Y0 line)
(expect: to X-18.761 Y32.495 involute I0 J0)
(expect: to X20 Y0 involute I0 J0)
S1000M03
G01X20.Y0.F500.
G03.2X-18.761Y32.495I-20.J0.R8.
G02.2X20.Y0.I18.761J-32.495R8.
M30
%
