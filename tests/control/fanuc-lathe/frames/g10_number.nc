%
O0001
(rule: F 3.4 P out of the range: PS0031)
(expect: alarm PS0031 K5281 at 5:1)
G10P1000X1.
M30
%
