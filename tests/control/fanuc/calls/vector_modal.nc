%
O0001
(rule: F 12 G66: called behind X10 and behind Y5, not by M08 and not behind G67)
(expect: #100=2)
#100=0
G66P9200A1.
M08
X10.
Y5.
G67
X0
M30
O9200
#100=#100+1
M99
%
