%
O0001
(rule: F 5.6 G75: strokes along X on the radius, plunges along Z)
(expect: path X50Z-10 x46f0.1 X46.6 x42 X42.6 x40 X50 Z-12.5 x46 X46.6 x42 X42.6 x40 X50 Z-14 x46 X46.6 x42 X42.6 x40 X50 Z-10)
G99 G97 S500 M03
G00 X50. Z-10.
G75 R0.3
G75 X40. Z-14. P2000 Q2500 F0.1
M30
%
