%
O00001
(rule: Haas alarm 339: two codes of one group)
(expect: alarm 339 K5008 at 5:5)
G00 G01 X1.
M30
%
