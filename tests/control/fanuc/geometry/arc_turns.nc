%
O0001
(rule: F 3.5 L is the number of turns only with spiral interpolation)
(expect: alarm PS0009 K5010 at 5:16)
G02X0Y0I10.Z-5.L3F100
M30
%
