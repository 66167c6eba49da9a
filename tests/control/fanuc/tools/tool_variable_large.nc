%
O0001
(rule: F 11 PS0032 also via #)
(expect: alarm PS0032 K5282 at 5:1)
#11001=1000
M30
%
