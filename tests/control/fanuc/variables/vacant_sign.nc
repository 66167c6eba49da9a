%
O0001
(rule: F 6.3 X-#1: a sign does not make a word of a vacant variable)
(expect: to X10 Z5)
(expect: to X10 Y3 Z5)
(expect: to X10 Y3 Z3)
(expect: #3=0)
(expect: #100 vacant)
G00X10.Z5.
G00Z-#1Y3.
X-#1Y-#2Z3.
#3=-#1
G65P9100A-#1
M30
O9100
#100=#1
M99
%
