%
O0001
(rule: F 6.11 M96 P, M97: no signal interrupts here)
(expect: warning K5345 at 7:1)
(expect: warning K5345 at 9:1)
(expect: to X1)
M96P100
G00X1.
M97
M30
%
