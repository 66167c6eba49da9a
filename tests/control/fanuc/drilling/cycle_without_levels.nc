%
O0001
(rule: F 5.1 R and Z that were not said since G80 are 0: nothing is cut)
(expect: path Z20 X40 Z0 f50 Z20 X50 Z0 Z20)
G00Z20.S1000M3
G80
G98G81X40.F50
X50.
G80
M30
%
