%
O0001
(rule: F 1.1 ; and LF end a block, CR is ignored)
(expect: to X1 rapid)
(expect: to X2 rapid)
G00X1.;
X2.
M30
%
