%
O0001
(rule: F 4.2 G53 suspends the length for its block)
(expect: #1=-5)
(expect: #2=40)
G10L10P1R10.
G43H1Z50.
G53Z-5.
#1=#5023
Z30.
#2=#5023
M30
%
