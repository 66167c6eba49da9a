%
O00001
(rule: Haas G90, G91: coordinates and distances)
(expect: to X10 Y5)
(expect: to X15 Y5)
(expect: to X15 Y2)
G90 G00 X10. Y5.
G91 X5.
Y-3.
G90
M30
%
