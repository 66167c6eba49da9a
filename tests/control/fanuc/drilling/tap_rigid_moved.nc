%
O0001
(rule: F 5.3 PS0204: an axis moves between M29 and G84)
(expect: alarm PS0204 K5246 at 7:1)
M3S500G00Z20.
M29S500
X5.
G84X10.Z-10.R2.F500.
M30
%
