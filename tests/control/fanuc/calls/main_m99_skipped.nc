%
O0001
(rule: F 6.8 /M99 in front of M30: one pass as well, whatever the operator would do)
(expect: warning K5900 at 6:2)
#100=#100+1
/M99
M30
%
