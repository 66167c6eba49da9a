%
O0001
(rule: F 4.3 back on the same line: square off the end)
(expect: to X0 Y0)
(expect: to X-5 Y20)
(expect: to X-5 Y55)
(expect: to X5 Y55)
(expect: to X5 Y20)
(expect: to X0 Y-20)
M3S1000
G10L12P1R5.
G00X0Y0
G41D1G01X0Y20.F100
Y50.
Y20.
G40X0Y-20.
M30
%
