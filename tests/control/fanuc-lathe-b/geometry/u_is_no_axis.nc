%
O0001
(rule: F 2.3 T-B: U is no distance along X)
(expect: alarm PS0009 K5010 at 6:5)
G90 G95 G97 S500 M03
G00 U10.
M30
%
