%
O0001
(rule: F 2.3 T-B: G92 sets the speed limit and the position, G94 and G95 the feed)
(expect: path X20Z3 X35 z-1f100)
G90 G94 G97 S500 M03
G92 S3000
G00 X20. Z3.
G92 X10.
X25.
G01 Z-1. F100.
M30
%
