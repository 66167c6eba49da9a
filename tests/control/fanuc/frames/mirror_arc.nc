%
O0001
(rule: F 12 G51.1 X0: an arc turns the other way)
(expect: to X0 Y0)
(expect: to X-10 Y10 ccw)
G51.1X0
G01X0Y0F100
G02X10.Y10.R10.
M30
%
