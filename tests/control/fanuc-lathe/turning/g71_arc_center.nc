%
O0001
(rule: F 5.6, 3.5 G71: an arc by its centre, I on the radius)
(expect: path X44Z2 X36 z-14f0.2 x37z-13.5 Z2 X28 z-10.835 x29z-10.335 Z2 X20 z-10 ccw:x40z-20 x44 Z2)
G99 G97 S500 M03
G00 X44. Z2.
G71 U4. R0.5
G71 P10 Q20 F0.2
N10 G00 X20.
G01 Z-10.
G03 X40. Z-20. I0. K-10.
N20 G01 X44.
M30
%
