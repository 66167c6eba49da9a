%
O0205(DIRECT DRAWING)
(rule: F 3.8: chamfers, corners and angles behind commas)
(expect: path Z2 z0f0.2 x18 x20z-1 z-14.464 cw:x20.536z-15.464 x29.732z-23.428 ccw:x30z-23.928 z-29.5 x31z-30 x40)
(expect: path z-41.34 x50z-50 X100Z50)
T0101
G97S1000M3
G0X0Z2.
G1Z0F.2
X20.,C1.
Z-15.,R2.
X30.,A150.,R1.
Z-30.,C.5
X40.,A90.
,A180.
X50.Z-50.,A150.
G0X100.Z50.
M30
%
