%
O0001
(rule: F 3.3 G29 without a way to the reference point before: PS0305)
(expect: alarm PS0305 K5344 at 5:1)
G29X3.
M30
%
