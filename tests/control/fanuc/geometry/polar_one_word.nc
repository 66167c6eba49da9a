%
O0001
(rule: F 3.6 G16: radius and angle stay where they are not said)
(expect: to X10 Y10)
(expect: to X0 Y14.1421)
(expect: to X0 Y5)
G90X10.Y10.
G16
Y90.
X5.
M30
%
