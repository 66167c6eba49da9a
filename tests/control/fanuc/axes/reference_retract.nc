%
O0001
(rule: F 12 G91G28Z0 at Z50: no motion to a place between)
(expect: to Z50)
(expect: to Z0)
G43H1Z50.
G91G28Z0.
M30
%
