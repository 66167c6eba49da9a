%
O0001
(rule: F 4.2 G28 leaves the length, the next move has it again)
(expect: #1=0)
(expect: #2=1)
(expect: #3=40)
G10L10P1R10.
G43H1Z50.
G91G28Z0
G90
#1=#5023
#2=#4111
Z30.
#3=#5023
M30
%
