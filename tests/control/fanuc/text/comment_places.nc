%
O0001
(rule: F 1.5 comments before N, between and behind words; they do not nest)
(expect: to X1 rapid)
(A)N10(B)G00(C (D)X1.(E)
M30
%
