%
O0001
(rule: F 3.3 G53 in G91 is ignored)
(expect: to X5)
(expect: warning K5233 at 8:4)
(expect: to X6)
G00X5.
G91G53Z0
X1.
M30
%
