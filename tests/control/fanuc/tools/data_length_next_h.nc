%
O0001
(rule: F 4.2 with No.5001#6 EVO = 0 a length that is written acts with the next H)
(expect: #1=100)
(expect: #2=100)
(expect: #3=101)
G10L10P1R100.
G43H1G00Z0.
#1=#5023
G10L11P1R1.
Z0.
#2=#5023
H1Z0.
#3=#5023
M30
%
