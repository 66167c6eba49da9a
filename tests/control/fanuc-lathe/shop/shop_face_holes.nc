%
O0208(C AXIS HOLES)
(rule: F 5.4: holes in the face by C, in the side by C and H, drilled and tapped in the centre)
(machine: driven)
(expect: path X50Z5 Z2 z-3f100 Z2 Z-2 z-8 Z2 Z-7 z-13 Z2 Z-12 z-18 Z2 Z-17 z-20 Z5 C90 Z2 z-3 Z2 Z-2 z-8 Z2 Z-7 z-13 Z2)
(expect: path Z-12 z-18 Z2 Z-17 z-20 Z5 C180 Z2 z-3 Z2 Z-2 z-8 Z2 Z-7 z-13 Z2 Z-12 z-18 Z2 Z-17 z-20 Z5 C270 Z2 z-3 Z2)
(expect: path Z-2 z-8 Z2 Z-7 z-13 Z2 Z-12 z-18 Z2 Z-17 z-20 Z5 X70Z-10 X64 x58f80 X64 X60 x52 X64 X54 x46 X64 X48 x40)
(expect: path X70 C315 X64 x58 X64 X60 x52 X64 X54 x46 X64 X48 x40 X70 X0Z5 Z2 z-4f0.1 Z2 Z-3 z-10 Z2 Z-9 z-16 Z2 Z-15)
(expect: path z-22 Z2 Z-21 z-28 Z2 Z-27 z-30 Z5 Z2 z-15f1.25 z2 Z5)
(expect: dwell 0.5)
(expect: dwell 0.5)
G98G97S1000M3
G0X50.Z5.C0
G83Z-20.R-3.Q5000F100K1
C90.
C180.
C270.
G80
G0X70.Z-10.
G87X40.R-3.Q3000P500F80
H45.
G80
G97S500M3
G99
G0X0Z5.
G83Z-30.R-3.Q6000F.1
G80
G84Z-15.R-3.F1.25
G80
M30
%
