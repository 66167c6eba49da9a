%
O00001
(rule: Haas alarm 503: there is no such variable)
(expect: alarm 503 K5410 at 5:1)
#200=1
M30
%
