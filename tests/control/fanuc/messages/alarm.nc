%
O0001
(rule: F 6.5 #3000 raises MC3000+n)
(expect: alarm MC3023 K5450 at 9:1)
(expect: #1=1)
(expect: to X5)
#1=1
G00X5.
#3000=23(TOOL BROKEN)
G00X9.
M30
%
