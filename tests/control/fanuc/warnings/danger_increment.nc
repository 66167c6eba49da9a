%
O0001
(rule: technologist, wrong motion: an increment behind the change takes the length of the tool along)
(expect: warning K5976 at 7:9)
T1M6
S1000M3
G91G43H1Z-100.
G90Z100.
G91Z-100.
M30
%
