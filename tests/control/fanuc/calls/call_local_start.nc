%
O0001
(rule: F 6.8 M98 Q L calls a part of the same program)
(expect: #100=2)
M98Q50L2
M30
N50#100=#100+1
M99
%
