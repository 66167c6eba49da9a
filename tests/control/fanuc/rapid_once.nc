%
O0001
(rule: F 3.3 G60: rapid to the place, the modal motion stays)
(expect: line to X5 F100)
(expect: rapid to X10)
(expect: line to X12 F100)
S500M3
G01X5.F100
G60X10.
X12.
M30
%
