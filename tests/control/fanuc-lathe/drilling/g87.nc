%
O0001
(rule: F 5.4 G87: from the side, R a distance on the radius, X a diameter, strokes, back to the start)
(expect: path X60Z-10 X50 x38f0.1 X50 X40 x26 X50 X28 x20 X60 Z-20 X50 x38 X50 X40 x26 X50 X28 x20 X60)
G99G97S500M03
T0101
G00X60.Z-10.
G87X20.R-5.Q6000F0.1
Z-20.
G80
M30
%
