%
O0001
(rule: G50 S limits the speed; an edge that turns its turret in the cut does not)
(machine: lathe)
(expect: warning K5975 at 11:1)
T0101
G50S2500
G96S200M3
G0X60.Z0
G1X0F0.2
T0202
G0X60.
M30
%
