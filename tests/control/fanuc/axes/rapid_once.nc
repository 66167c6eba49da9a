%
O0001
(rule: F 3.3 G60: rapid to the place, the modal motion stays)
(expect: to X5 line F100)
(expect: to X10 rapid)
(expect: to X12 line F100)
S500M3
G01X5.F100
G60X10.
X12.
M30
%
