%
O0001
(rule: F 6.8 the caller is searched from its head)
(expect: #100=3)
N10#100=#100+1
IF[#100GE3]GOTO20
M98P2
N20M30
O0002
M99P10
%
