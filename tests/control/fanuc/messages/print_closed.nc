%
O0001
(rule: F 6.10 POPEN is needed)
(expect: alarm PS1143 K5487 at 5:1)
DPRNT[A]
M30
%
