%
O0001
(rule: F 2.3 G35: an arc of more than half a turn goes back along its axis)
(expect: alarm  K5570 at 7:1)
G00X0Z0
S300M03
G18G35X10.Z12.R-20.F2.
M30
%
