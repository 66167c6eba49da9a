%
O0001
(rule: F 11 PS0031 there are six work offsets)
(expect: alarm PS0031 K5281 at 5:6)
G10L2P7X0.
M30
%
