%
O0001
(rule: F 4.3 PS0041: a slot narrower than the tool)
(expect: alarm PS0041 K5277 at 10:1)
M3S1000
G10L12P1R5.
G00X0Y0
G41D1G01X0Y20.F100
Y50.
X-8.
Y20.
G40X-8.Y-20.
M30
%
