%
O0001
(rule: F 5.6 G71: cuts end on the arcs of the shape, the last one follows them)
(expect: path X44Z2 X36 z-19.798f0.2 x37z-19.298 Z2 X28 z-18 x29z-17.5 Z2 X20 z-10 cw:x40z-20 x44 Z2)
G99 G97 S500 M03
G00 X44. Z2.
G71 U4. R0.5
G71 P10 Q20 F0.2
N10 G00 X20.
G01 Z-10.
G02 X40. Z-20. R10.
N20 G01 X44.
M30
%
