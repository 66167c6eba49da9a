%
O0001
(rule: F 2.5 D and H are modal, G40 and G49 keep them; D00 and H00)
(expect: #1=1)
(expect: #2=2)
(expect: #3=0)
(expect: #4=0)
D1H2
G40G49
#1=#4107
#2=#4111
D00H00
#3=#4107
#4=#4111
M30
%
