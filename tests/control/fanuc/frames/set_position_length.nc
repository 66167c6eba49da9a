%
O0001
(rule: F 3.4 G92 under a tool length: the place before it is set)
(expect: #1=0)
(expect: #2=60)
(expect: #3=70)
G10L10P1R10.
G43H1Z50.
G92Z0
#1=#5003
#2=#5023
Z10.
#3=#5023
M30
%
