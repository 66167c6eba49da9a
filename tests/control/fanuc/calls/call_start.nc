%
O0001
(rule: F 6.8 M98 P Q starts at that block)
(expect: #100 vacant)
(expect: #101=2)
M98P2Q10
M30
O0002
#100=1
N10#101=2
M99
%
