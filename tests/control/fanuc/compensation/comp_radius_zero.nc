%
O0001
(rule: F 4.3 with D0 the path is the programmed one, and nothing interferes: a circle between its leads)
(expect: to X100 Y30)
(expect: to X110 Y40)
(expect: to X120 Y30 cw)
(expect: to X120 Y30 cw)
(expect: to X110 Y20 cw)
(expect: to X100 Y30)
G17G90G40
M3S1000
G00X100.Y30.
G01F200.G42D0X110.Y40.
G02X120.Y30.I0.J-10.
I-10.J0.
X110.Y20.I-10.J0.
G40G01X100.Y30.
M30
%
