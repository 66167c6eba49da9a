%
O0001
(rule: F 2.4 M30 ends the run in a subprogram as well)
(expect: #100=1)
(expect: #101 vacant)
M98P2
#101=1
M30
O0002
#100=1
M30
M99
%
