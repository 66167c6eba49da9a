%
O0001
(rule: technologist, wrong motion: above max_feed of the machine, also by the turns of the spindle)
(machine: trunnion-ac)
(expect: warning K5972 at 9:7)
(expect: warning K5972 at 11:8)
T1M6S10000M3
G43H1G0Z5.
G1X10.F500000.
X20.F20000.
G95X30.F3.
M30
%
