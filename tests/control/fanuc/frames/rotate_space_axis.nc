%
O0001
(rule: F 3.7 a rotation in space about no axis)
(expect: alarm PS5044 K5666 at 5:1)
G68X0Y0Z0I0J0K0R30.
M30
%
