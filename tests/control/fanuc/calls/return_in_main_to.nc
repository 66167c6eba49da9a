%
O0001
(rule: F 6.8 M99 P in the main program jumps)
(expect: #100 vacant)
(expect: #101=1)
M99P20
#100=1
N20#101=1
M30
%
