%
O0001
(rule: F 11 PS0032 an offset has three digits before the point)
(expect: alarm PS0032 K5282 at 5:1)
G10L10P1R1000.
M30
%
