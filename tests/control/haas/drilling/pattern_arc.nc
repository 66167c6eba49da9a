%
O00001
(rule: Haas G71: holes on an arc, K below 0 clockwise; the middle stands in its block)
(expect: path Z10 X10Y5 X20 Z2 z-5f100 Z2 X10Y-5 z-5 Z2)
S500 M03
G00 Z10.
G81 G99 Z-5. R2. F100. L0
G71 X10. Y5. I10. J0. K-90. L2
G80
M30
%
