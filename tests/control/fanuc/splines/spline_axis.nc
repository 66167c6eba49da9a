%
O0001
(rule: F 11 PS2003: an axis that is no part of the curve)
(expect: alarm PS2003 K5207 at 7:12)
G05.1Q1
G01X0Y0F100M3S500
G06.2K0X0Y0A5.
M30
%
