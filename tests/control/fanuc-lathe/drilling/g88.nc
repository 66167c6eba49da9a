%
O0001
(rule: F 5.4 G88: taps from the side, back at R, up at rapid)
(expect: path X60Z-10 X50 x30f1 x50 X60)
G99G97S500M03
T0101
G00X60.Z-10.
G88X30.R-5.F1.
G80
M30
%
