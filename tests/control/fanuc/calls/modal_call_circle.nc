%
O0001
(rule: F 6.8 G66: called after every block that moves an axis, a full circle too)
(expect: #100=2)
G17 G90 G94 S1000 M3 F500
G1 X10. Y0
G66 P9100
G1 X20.
G3 I-3.
G67
M30
O9100
#100=#100+1
M99
%
