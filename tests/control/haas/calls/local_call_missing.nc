%
O00001
(rule: Haas M97 P: alarm 337 where there is no such block)
(expect: alarm 337 K5431 at 5:1)
M97 P1000
M30
%
