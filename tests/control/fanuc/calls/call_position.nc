%
O0001
(rule: F 6.9 a macro reads where the block before has come to)
(expect: #100=12)
G00X12.
G65P2
M30
O0002
#100=#5041
M99
%
