%
O0001
(rule: F 6.8 M99 L0 leaves at once)
(expect: #100=1)
M98P2L5
M30
O0002
#100=#100+1
M99L0
%
