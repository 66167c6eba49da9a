%
O0001
(rule: F 6.8 words behind the call as well)
(expect: to X5)
(expect: to X1)
G00M98P2X5.
M30
O0002
X1.
M99
%
