%
O0001
(rule: F 3.6 G07 Y0: not executed)
(expect: alarm PS0010 K5002 at 5:1)
G07Y0
M30
%
