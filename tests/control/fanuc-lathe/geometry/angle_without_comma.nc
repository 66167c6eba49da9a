%
O0001
(rule: F 3.5 A without its comma on a lathe)
(machine: lathe)
(expect: fix the angle of a line is `,A90.`, with a comma)
(expect: alarm PS0009 K5230 at 8:4)
T0101
G01A90.R0.5F0.1
M30
%
