%
O0001
(rule: F 3.5 C without its comma on a lathe without a C axis, as No.3405#4 has it)
(machine: lathe)
(expect: fix a chamfer is `,C0.4`, with a comma)
(expect: alarm PS0009 K5230 at 8:8)
T0101S500M03
G01X100.C0.4F0.1
M30
%
