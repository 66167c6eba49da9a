%
O00001
(rule: Haas G72: holes along a line, the first where the tool stands; G80 ends the cycle behind it)
(expect: path X10Y5Z10 Z2 z-5f100 Z10 Y15 Z2 z-5 Z10 Y25 Z2 z-5 Z10 X0)
S500 M03
G00 X10. Y5. Z10.
G81 Z-5. R2. F100. L0
G72 I10. J90. L3
G80
G00 X0
M30
%
