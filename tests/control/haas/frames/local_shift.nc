%
O00001
(rule: Haas G52: a shift of all offsets, until it is set back)
(expect: to X5 Y0)
(expect: to X0 Y0)
G52 X5.
G00 X0. Y0.
G52 X0. Y0. Z0.
X0.
M30
%
