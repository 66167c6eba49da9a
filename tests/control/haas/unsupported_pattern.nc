%
O00001
(rule: Haas G70: a pattern of holes, not executed)
(expect: alarm  K5018 at 5:1)
G70 I10. J0 L6
M30
%
