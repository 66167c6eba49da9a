(rule: F 1.2 what is wrong in a line with blanks inside of words is told by the column in which it stands)
(expect: alarm PS0112 K5420 at 3:10)
#1 0 1=3 /0
M30
