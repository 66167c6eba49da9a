%
O00001
(rule: Haas alarm 508: division by zero)
(expect: alarm 508 K5420 at 5:7)
#100=1/0
M30
%
