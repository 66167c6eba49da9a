%
O0001
(rule: F 5.3 M29 S, then G84: F pitch times speed under G94)
M3S500
G00Z20.
M29S500
G84X10.Z-10.R2.F500.
G80
M30
%
