%
O0001
(rule: F 6.8 No.6080: an M code calls O9020 as G65 does)
(expect: #100=8)
M60A8.
M30
O9020
#100=#1
M99
%
