%
O0001
(rule: F 3.5, 12 half circles by R and I, a full circle)
(expect: to X20 Y0 cw I10 J0)
(expect: to X0 Y0 line)
(expect: to X0 Y0 rapid)
(expect: to X20 Y0 ccw I10 J0)
(expect: to X0 Y0 rapid)
(expect: to X0 Y0 ccw I10 J0)
G17G02X20.Y0R10.F100
X0Y0
G00X0Y0
G03X20.Y0I10.J0
G00X0Y0
G03X0Y0I10.
M30
%
