%
O0001
(rule: F 6.7 an endless loop of motions, cut off)
(expect: alarm  K5440 at 6:1)
DO1
G00X1.
X2.
END1
M30
%
