%
O0001
(rule: F 2.3 G54 to G59, G52, G53 as on a mill)
(expect: to Z-9)
(expect: to Z-4)
(expect: to Z-50)
(expect: to Z-9)
G10L2P2X0Z-10.
G55G00Z1.
G52Z5.
Z1.
G53Z-50.
G52Z0
Z1.
M30
%
