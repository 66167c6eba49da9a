%
O0001
(rule: F 5.6 G74: strokes along Z, plunges along X, relief off the wall, the last one exact)
(expect: path X40Z2 z-4f0.1 Z-3 z-10 Z-9 z-15 X41 Z2 X32 z-4 Z-3 z-10 Z-9 z-15 X33 Z2 X28 z-4 Z-3 z-10 Z-9 z-15 X29 Z2 X40)
G99 G97 S500 M03
G00 X40. Z2.
G74 R1.
G74 X28. Z-15. P4000 Q6000 R0.5 F0.1
M30
%
