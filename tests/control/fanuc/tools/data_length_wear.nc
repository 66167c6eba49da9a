%
O0001
(rule: F 4.1 memory C: the length that acts is geometry and wear)
(expect: #1=100.25)
(expect: #2=0.25)
G10L10P1R100.
G10L11P1R.25
G43H1G00Z0.
#1=#5023
#2=#10001
M30
%
