%
O0001
(rule: F 6.8 M99 P goes on at that block of the caller)
(expect: #100=1)
(expect: #101 vacant)
#100=1
M98P2
#101=1
N20
M30
O0002
M99P20
%
