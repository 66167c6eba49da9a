%
O00001
(rule: Haas macro variables: codes, feed, speed, tool; commons that are kept; a stop with a message)
(expect: #500=1)
(expect: #1=300)
(expect: #2=1200)
(expect: #3=1)
(expect: #4=10)
(expect: message CHECK)
(expect: stop)
T1 M06
S1200 M03
G00 X10. F300.
#500=1
#1=#4109
#2=#4119
#3=#4120
#4=#5021
#3006=1(CHECK)
M30
%
