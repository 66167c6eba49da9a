%
O00001
(rule: Haas: one M a block is the rule; the chip conveyor M31 moves nothing)
(expect: to X1)
M31
G00 X1.
M33
M30
%
