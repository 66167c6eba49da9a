%
O0001
(rule: F 12 G65 hides #33, M98 does not)
(expect: #100 vacant)
(expect: #101=1)
(expect: #102=1)
#33=1
G65P9205
#101=#33
M98P8
M30
O9205
#100=#33
M99
O0008
#102=#33
M99
%
