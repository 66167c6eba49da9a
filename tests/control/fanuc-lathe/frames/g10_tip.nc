%
O0001
(rule: F 3.4 Q is the tip, 0 to 9)
(expect: alarm PS0032 K5282 at 5:1)
G10P10001Q10
M30
%
