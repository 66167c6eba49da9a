%
O0001
(rule: F 6.3, 6.8: the word of a vacant value is not there, so nothing is called)
(expect: #100 vacant)
(expect: #101=7)
(expect: to X10 rapid)
T#1
G00 X10. S#1
#1=7
T#1
M30
O9000
#100=#101
#101=#149
M99
O9029
#101=99
M99
%
