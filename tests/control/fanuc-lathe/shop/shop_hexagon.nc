%
O0206(HEX BY G12.1)
(rule: F 3.6 G12.1: a hexagon on the face, X a diameter and C in mm)
(machine: driven)
(expect: path X60Z5 z-5f500 x34.64f200 y10c30.001 x0y20c90 x-34.64y10c149.999 y-10c210.001 x0y-20c270)
(expect: path x34.64y-10c329.999 y0c360 x60 Z50)
G98G97S2000M3
G0X60.C0Z5.
G1Z-5.F500
G12.1
G42G1X34.64C0F200
C10.
X0C20.
X-34.64C10.
C-10.
X0C-20.
X34.64C-10.
C0
G40X60.
G13.1
G0Z50.
G99
M30
%
