%
O00001
(rule: Haas alarm 310: no such G code)
(expect: alarm 310 K5002 at 5:1)
G77.7 X1.
M30
%
