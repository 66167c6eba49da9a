%
O00001
(rule: Haas G55: the second work offset)
(expect: to X10 Y20)
(expect: to X0 Y0)
G55 G00 X0. Y0.
G54 X0. Y0.
M30
%
