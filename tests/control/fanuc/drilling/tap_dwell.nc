%
O0001
(rule: F 5.2 G84: P waits at the bottom; the dwell at R is not executed, see dialects/fanuc.xml)
(expect: path Z20 X10 Z3 z-10f1 z3 Z20)
(expect: dwell 0.5)
G94
G00Z20.
S500M03
G84X10.Z-10.R3.P500F500.
G80
M30
%
