%
O0001
(rule: F 6.8, 1.5: a comment without an end is told under G66.1 as well, be it alone or behind arguments)
(expect: alarm PS0004 K5019 at 7:4)
G66.1P2
N5
X5.(OPEN
G67
M30
O0002
M99
%
