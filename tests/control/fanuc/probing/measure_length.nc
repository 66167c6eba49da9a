%
O0001
(rule: F 2.2 G37: the tool goes to the sensor at rapid; here it has the length that its offset says)
(expect: warning K5574 at 8:1)
(expect: path Z100 Z10)
(expect: #1=10)
G43H1Z100.
G37Z10.
#1=#5043
M30
%
