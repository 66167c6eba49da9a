%
O00001
(rule: Haas G70: no cycle is active)
(expect: alarm 306 K5253 at 6:1)
G00 X10. Y5.
G70 I10. J0. L4
M30
%
