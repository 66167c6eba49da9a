%
O0001
(rule: F 1.6 P takes no decimal point)
(expect: alarm PS0007 K5005 at 5:4)
M98P1.5
M30
%
