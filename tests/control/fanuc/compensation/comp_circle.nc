%
O0001
(rule: F 4.3 ways that touch do not interfere: a circle between its leads, cutter inside)
(expect: to X100 Y30)
(expect: to X110 Y35)
(expect: to X115 Y30 cw I110 J30)
(expect: to X115 Y30 cw I110 J30)
(expect: to X110 Y25 cw I110 J30)
(expect: to X100 Y30)
G10L12P1R5.
G17G90G40
M3S1000
G00X100.Y30.
G01F200.G42D1X110.Y40.
G02X120.Y30.I0.J-10.
I-10.J0.
X110.Y20.I-10.J0.
G40G01X100.Y30.
M30
%
