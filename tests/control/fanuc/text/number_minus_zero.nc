%
O0001
(rule: F 1.6 -0. is 0)
(expect: to X5)
(expect: to X0)
X5.
X-0.
M30
%
