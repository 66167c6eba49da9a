%
O0001
(rule: F 4.1 a negative D exchanges left and right)
(expect: to X0 Y0)
(expect: to X5 Y20)
(expect: to X5 Y50)
(expect: to X0 Y80)
M3S1000
G10L12P1R-5.
G00X0Y0
G41D1G01X0Y20.F100
Y50.
G40X0Y80.
M30
%
