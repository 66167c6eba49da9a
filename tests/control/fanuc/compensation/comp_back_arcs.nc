(rule: F 4.3 two arcs that turn back at their corner, on the cutter's side: an inside corner)
(expect: to X0 Y0 Z0 rapid)
(expect: to X5 Y0 rapid)
(expect: to X30 Y11.180340 cw I20 J0)
(expect: to X55 Y0 cw I40 J0)
(expect: to X60 Y10)
G10 L12 P1 R5.
G17 G21 G90 G94 M3 S1000
G00 X0 Y0 Z0
G41 D1 X10. Y0
G02 X30. Y0 R10. F100.
X50. Y0 R10.
G40 G01 X60. Y10.
M30
