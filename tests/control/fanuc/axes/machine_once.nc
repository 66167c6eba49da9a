%
O0001
(rule: F 3.3 G53 holds for its block; the modal motion stays)
(expect: to X-299 line)
(expect: to X-100 rapid)
(expect: to X-298 line)
G10L2P1X-300.Y0Z0
G54G01F100M3S500
X1.
G53X-100.
X2.
M30
%
