%
O0001
(rule: F 1.6 H0 to H400: PS0030)
(expect: alarm PS0030 K5023 at 5:7)
G43Z1.H401
M30
%
