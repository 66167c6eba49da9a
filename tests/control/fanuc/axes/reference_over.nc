%
O0001
(rule: F 3.3 G28 over the place that it names, named axes alone)
(expect: to X10 Y10 Z10)
(expect: to X20 Y10 Z30 rapid)
(expect: to X0 Y10 Z0 rapid)
X10.Y10.Z10.
G28X20.Z30.
M30
%
