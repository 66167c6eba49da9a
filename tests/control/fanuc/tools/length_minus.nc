%
O0001
(rule: F 4.2 G44: the offset counts the other way)
(expect: to Z10)
(expect: #1=-20)
G10L10P3R20.
G44G00Z10.H3
#1=#5083
M30
%
