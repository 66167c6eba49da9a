%
O0001
(rule: F 6.5 #3006 stops with a message)
(expect: message CHECK THE TOOL)
(expect: stop)
(expect: to X1)
(expect: to X2)
G00X1.
#3006=1(CHECK THE TOOL)
X2.
M30
%
