%
O0001
(rule: F 2.2 G75, G77 to G79 are of grinding machines: PS0010 without the option)
(expect: alarm PS0010 K5002 at 5:1)
G75X1.
M30
%
