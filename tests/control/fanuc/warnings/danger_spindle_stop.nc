%
O0001
(rule: technologist, wrong motion: the spindle stops below the last retract; straight down is a bore)
(expect: warning K5981 at 10:1)
T1M6S1000M3
G43H1G0X0Y0Z50.
Z2.
G1Z-5.F100.
X50.
M5
G0Z50.
M3
G1Z40.
M5
G0Z50.
M30
%
