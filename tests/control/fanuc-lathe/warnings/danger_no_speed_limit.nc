%
O0001
(rule: technologist, wrong motion: G96 to the centre without G50 S)
(machine: lathe)
(expect: warning K5974 at 9:3)
T0101
G96S200M3
G0X60.Z0
G1X0F0.2
G0Z2.
M30
%
