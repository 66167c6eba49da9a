%
O0001
(rule: F 5.4, 5.1 without R the drilling begins where the tool stands, no warning)
(expect: path Z5 z-20f0.1 Z5)
G99G97S500M03
T0101
G00X0Z5.
G83Z-20.F0.1
G80
M30
%
