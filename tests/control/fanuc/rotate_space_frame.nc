%
O0001
(rule: F 3.7 G68 with I J K: in space, not executed)
(expect: alarm PS0010 K5013 at 5:1)
G68X0Y0Z0I0J0K1R30.
M30
%
