%
O00001
(rule: Haas G12: a pocket that is not wider than the cutter)
(expect: alarm 359 K5253 at 8:1)
T1 M06
S500 M03
G00 X10. Y5.
G12 I3. D3 Z-5. F100.
M30
%
