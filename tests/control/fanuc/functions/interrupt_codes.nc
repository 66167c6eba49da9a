%
O0001
(rule: F 2.4 M96 P: told, no signal comes here)
(expect: warning K5345 at 5:1)
M96P2
M30
%
