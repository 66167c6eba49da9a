%
O0001
(rule: F 6.12 No.6000#0 = 1: G67 without G66 is ignored)
(expect: to X1)
G00
G67
X1.
M30
%
