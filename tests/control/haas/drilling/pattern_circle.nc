%
O00001
(rule: Haas G70: holes on a circle about the place of the tool, all around; L0 keeps the cycle from the middle)
(expect: path X10Y5 Z10 X20 Z2 z-5f100 Z10 X10Y15 Z2 z-5 Z10 X0Y5 Z2 z-5 Z10 X10Y-5 Z2 z-5 Z10 X50Y50)
S500 M03
G00 X10. Y5.
Z10.
G81 Z-5. R2. F100. L0
G70 I10. J0. L4
G80
G00 X50. Y50.
M30
%
