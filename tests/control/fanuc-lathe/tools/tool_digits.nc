%
O0001
(rule: F 2.3 T has eight digits at the most)
(machine: lathe)
(expect: alarm PS0003 K5004 at 6:1)
T12345678901
M30
%
