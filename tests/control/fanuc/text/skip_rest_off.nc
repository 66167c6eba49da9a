%
O0001
(rule: F 1.4 a sign in the middle: the rest of the block is left out while the switch is on)
(skip: 2)
(expect: to X1 Y5)
(expect: to X2 Y5)
(expect: to X3 Y5)
G00X1./Y5.
N5/G00X2.
X3./2Y9.
M30
%
