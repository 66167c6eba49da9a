%
O0001
(rule: F 11 PS0190: there is no axis P9 for G96)
(expect: alarm PS0190 K5012 at 5:4)
G96P9S100
M30
%
