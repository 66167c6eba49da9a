%
O0001
(rule: F 3.2 G08, G05.1, G05: nothing of the path changes)
(expect: to X1)
G08P1
G08P0
G05.1Q1
G05.1Q0
G05P10000
G05P0
X1.
M30
%
