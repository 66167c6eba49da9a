%
O0001
(rule: F 6.3 X#1 vacant: the whole word is ignored)
(expect: #2 vacant)
(expect: to X5 Y5)
(expect: to X10 Y5)
G00 X5. Y5.
#2=#0
G90 G00 X10. Y#2
M30
%
