%
O0001
(rule: F 12 G66 twice: X10, then the last macro, from inside of it the first)
(expect: to X10)
(expect: to X10 Z2)
(expect: to X10 Y1 Z2)
G66P9201
G66P9202
X10.
G67
G67
M30
O9201
Y1.
M99
O9202
Z2.
M99
%
