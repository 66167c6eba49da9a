%
O0001
(rule: F 6.12 No.6000#0: G67 without G66)
(expect: alarm PS1100 K5467 at 5:1)
G67
M30
%
