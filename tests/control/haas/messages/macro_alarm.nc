%
O00001
(rule: Haas #3000: an alarm of the program, its number is 1000 more)
(expect: alarm 1015 K5450 at 5:1)
#3000=15(TOOL BROKEN)
M30
%
