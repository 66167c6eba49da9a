%
O0001
(rule: F 6.5 further numbers of variables)
(expect: #1=1)
(expect: #2 vacant)
(expect: #3=2.718281828)
(expect: #4=98)
(expect: #5=3)
(expect: #6=4)
(expect: #7=100)
(expect: #8=0)
(expect: #9=10)
(expect: #10=10)
(expect: #3003=1)
(expect: stop)
G98 G00 G43 H4 D3 X10. Y0. Z0.
#3003=1
#1=#3018
#2=#3100
#3=#3102
#4=#4010
#5=#4107
#6=#4111
#7=100
#8=#7001+#14001
#9=#100001
#10=#100101
#11=#100051
#12=#5083
#13=[#_ABSOT[1]]
#_MSGSTP=1
M30
%
