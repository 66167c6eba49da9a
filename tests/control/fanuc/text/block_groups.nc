%
O0001
(rule: F 1.3 several G codes of different groups in one block are all valid)
(expect: to X15 Y0)
(expect: to X5 Y10)
(expect: to X2 Y4)
(expect: to X-1)
(expect: to X1)
(expect: to X110)
G90G52X10.
G00X5.Y0
G52X0G00
G90G92X0Y0
G00X-10.Y10.
G92.1X0Y0
G90G51X0Y0Z0P2000
X1.Y2.
G50G90
G17G51.1X0
X1.
G50.1X0G90
X1.
G54G52X100.
X10.
M30
%
