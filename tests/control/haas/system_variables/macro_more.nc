%
O00001
(rule: Haas macro variables: clocks, settings of the panel, the last M, N and O)
(expect: #800=1)
(expect: #1=0)
(expect: #2=1)
(expect: #5=500)
(expect: #6=0)
(expect: #7=3)
(expect: #8=7)
(expect: #9=1)
(expect: #10=0)
#800=1
#2201=0.5
#3001=0
#3002=0
#10=#3002
#3003=1
#2=#3003
#3004=7
#1=0
IF [#3011 LT 20000101] THEN #1=1
T1 M06
S500 M03
#5=#3027
#6=#3030
#7=#4113
N7 G00 X1.
#8=#4114
#9=#4115
#11=#3012
M30
%
