%
O0001
(rule: F 4.3 turns upon each other are no bottleneck: a thread is milled in several turns)
(expect: to X0 Y0 rapid)
(expect: to X5 Y-2 line)
(expect: to X7 Y0 ccw)
(expect: to X7 Y0 ccw)
(expect: to X7 Y0 ccw)
(expect: to X5 Y2 ccw)
(expect: to X0 Y0 line)
G10L12P1R3.
G90G00X0Y0S1000M3
G41D1G01X5.Y-5.F200
G03X10.Y0R5.
G03I-10.
G03I-10.
G03X5.Y5.R5.
G01G40X0Y0
M30
%
