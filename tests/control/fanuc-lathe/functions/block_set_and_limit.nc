%
O0001
(rule: F 2.3 G50 X Z S in one block)
(expect: to X10)
G50X100.Z50.S2000
G00X120.
M30
%
