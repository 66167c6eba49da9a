%
O00001
(rule: Haas G101 and G100: mirrors the axes that are named)
(expect: to X-10 Y5)
(expect: to X10 Y5)
G101 X0.
G00 X10. Y5.
G100 X0. Y0. Z0.
X10. Y5.
M30
%
