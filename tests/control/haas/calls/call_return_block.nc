%
O00001
(rule: Haas M99 P: the caller goes on at block N)
(expect: to X1.)
(expect: to X3.)
M98 P20
G00 X2.
N100 X3.
M30
O00020
G00 X1.
M99 P100
%
