%
O0001
(rule: F 2.1, 2.3 state of a lathe at power-on: G00 G18 G99 by No.3402#4 FPM = 0, G40 G80 G97 G54)
(expect: #1=0)
(expect: #2=97)
(expect: #5=99)
(expect: #7=40)
(expect: #10=80)
(expect: #14=54)
(expect: #16=18)
#1=#4001
#2=#4002
#5=#4005
#7=#4007
#10=#4010
#14=#4014
#16=#4016
M30
%
