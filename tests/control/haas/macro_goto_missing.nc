%
O00001
(rule: Haas alarm 337: the block is not there)
(expect: alarm 337 K5431 at 5:5)
GOTO99
M30
%
