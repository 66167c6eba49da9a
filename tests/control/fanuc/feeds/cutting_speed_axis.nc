%
O0001
(rule: F 3.2 G96 P1: along the first axis)
(expect: to X5)
G96P1S100M3
G00X5.
G97S500
M30
%
