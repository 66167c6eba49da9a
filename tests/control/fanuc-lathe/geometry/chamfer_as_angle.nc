%
O0001
(rule: F 3.5 C without its comma on a lathe with a C axis turns the spindle's axis: told)
(machine: driven)
(expect: fix a chamfer is `,C0.4`, with a comma)
(expect: warning K5904 at 11:8)
T0101
G99G97S500M03F0.1
G00X20.Z2.
G01Z0
G01X18.C0.4
Z-5.
M30
%
