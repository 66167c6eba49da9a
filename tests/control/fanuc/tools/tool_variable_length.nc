%
O0001
(rule: F 6.5 memory C: 11000+N and 2200+N are the length)
(expect: #1=42)
(expect: #2=42)
(expect: #3=52)
#11007=42
#1=#2207
#2=#11007
G43H7G00Z10.
#3=#5023
M30
%
