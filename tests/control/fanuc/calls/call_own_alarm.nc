%
O0001
(rule: F 6.5 #3000 in a level)
(expect: alarm MC3007 K5450 at 9:1)
(expect: called 6:1)
G65P2
M30
O0002
#3000=7(NO)
M99
%
