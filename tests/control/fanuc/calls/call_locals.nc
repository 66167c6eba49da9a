%
O0001
(rule: F 6.8 G65 brings a new set of locals; the caller's come back)
(expect: #33=1)
(expect: #123 vacant)
#33=1
G65P9100
M30
%
