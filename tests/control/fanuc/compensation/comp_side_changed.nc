%
O0001
(rule: F 4.3 G42 behind G41 on lines: the tool crosses over)
(expect: to X0 Y0)
(expect: to X-5 Y20)
(expect: to X-5 Y50)
(expect: to X5 Y80)
(expect: to X5 Y90)
(expect: to X0 Y120)
M3S1000
G10L12P1R5.
G00X0Y0
G41D1G01X0Y20.F100
Y50.
G42Y80.
Y90.
G40X0Y120.
M30
%
