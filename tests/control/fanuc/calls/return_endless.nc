%
O0001
(rule: F 6.8 M99 at the end of the main program: it never ends by itself, so one pass is executed)
(expect: warning K5900 at 7:1)
(expect: #2=1)
#2=1
M99
%
