%
O00001
(rule: Haas alarm 337: the block is not there)
(expect: alarm 337 K5431 at 5:6)
GOTO 99
M30
%
