%
O0001
(rule: F 4.3 PS0041: an arc inside that is smaller than the tool)
(expect: alarm PS0041 K5275 at 10:1)
M3S1000
G10L12P1R5.
G00X0Y0
G01G41D1X0Y20.F100
Y50.
G03X-6.Y50.I-3.
G01Y20.
X-6.Y0
G40X0Y-20.
M30
%
