%
O0001
(rule: F 6.2 M98 keeps the locals of the caller)
(expect: #33=2)
(expect: #100=1)
#33=1
M98P8
M30
O0008
#100=#33
#33=2
M99
%
