%
O0001
(rule: F 3.7 arcs turn with G68)
(expect: to X0 Y10 cw I0 J5)
G68X0Y0R90.
G02X10.Y0R5.F100
M30
%
