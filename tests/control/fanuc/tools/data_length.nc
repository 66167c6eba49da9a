%
O0001
(rule: F 3.4, 4.1 G10 L10: length geometry of memory C; H uses it)
(expect: #1=150)
(expect: #2=120.5)
G10L10P3R120.5
G43H3G00Z29.5
#1=#5023
#2=#11003
M30
%
