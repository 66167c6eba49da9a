%
O00001
(rule: Haas macro variables: offsets, letters, the tool, G154, the probe)
(expect: #1=80)
(expect: #2=2)
(expect: #3=7)
(expect: #4=5)
(expect: #5=3)
(expect: #6=1)
#2001=80.
T1 M06
G43 H1 G00 Z5.
#1=#5083
G41 D2
G40
#2=#4107
G10 L20 P1 X7.
#3=#7001
G31 X5. F100.
#4=#5061
T3 M06
#5=#3026
#3901=#3901+1
#6=#3901
M30
%
