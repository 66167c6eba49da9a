%
O0001
(rule: a position that is named before the increment, or X and Y alone, is no danger; the end of the length is one)
(expect: warning K5976 at 9:4)
T1M6S1000M3
G91X10.Y5.
G90G43H1Z100.
G91Z-50.
G49Z10.
M30
%
