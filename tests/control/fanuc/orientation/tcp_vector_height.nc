(rule: F 4.7 G43.5 with the place to which the tip goes, as G43.4 takes it)
(machine: five-axis)
(expect: to Z60)
G43.5 H0 Z60.
M30
