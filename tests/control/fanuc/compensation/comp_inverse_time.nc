%
O0001
(rule: F 3.3, 4.3 G93 under G41: F of a line is feed by its length as it is programmed)
(expect: to X0 Y-20 Z10)
(expect: to X5 Y0 line F200)
(expect: to X5 Y15 line F100)
(expect: to X30 Y15 line F48)
(expect: to X60 Y20 line F100)
G10L12P1R5.
G17G90G40
M3S1000
G00X0.Y-20.Z10.
G42D1G01X0.Y0.F200.
G93Y20.F5.
X30.F1.6
G94G40X60.F100.
M30
%
