%
O00001
(rule: Haas G10 L12: the diameter of a cutter, not executed)
(expect: alarm  K5018 at 5:1)
G10 L12 P1 R10.
M30
%
