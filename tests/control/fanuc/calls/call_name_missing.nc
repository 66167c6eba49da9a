%
O0001
(rule: F 11 PS0310: no file of this name)
(expect: alarm PS0076 K5460 at 5:4)
M98<NOPE>
M30
%
