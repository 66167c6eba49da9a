%
O0001
(rule: F 3.4 G52 and G92 of B and C)
(machine: head-cb)
(expect: to B10 C20)
(expect: to B12 C20)
G52 B10. C20.
G0 B0 C0
G92 B5.
G92 C0
G0 B7. C0
G52 C0
M30
%
