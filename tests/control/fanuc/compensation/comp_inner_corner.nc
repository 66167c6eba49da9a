%
O0001
(rule: F 4.3 inner corner: where the offset lines meet)
(expect: to X0 Y0)
(expect: to X-5 Y20)
(expect: to X-5 Y45)
(expect: to X-50 Y45)
(expect: to X-50 Y0)
M3S1000
G10L12P1R5.
G00X0Y0
G41D1G01X0Y20.F100
Y50.
X-50.
G40X-50.Y0
M30
%
