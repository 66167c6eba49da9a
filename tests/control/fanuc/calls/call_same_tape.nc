%
O0001
(rule: F 7 programs behind the main program are called, M99 goes on behind the call)
(expect: to X1)
(expect: to X2)
(expect: to X3)
G00X1.
M98P2
X3.
M30
O0002
X2.
M99
%
