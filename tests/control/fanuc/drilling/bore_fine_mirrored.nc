%
O0001
(rule: F 5.2 G76 No.5148: the spindle stops at one angle whatever mirrors the program)
(expect: warning K5850 at 8:1)
G17G21G90
S500M3
G51.1X0
G76X10.Y0Z-20.R2.Q0.5F50
G80
G50.1X0
M30
%
