%
O0001
(rule: F 3.4 G10 L52 to G11: a parameter that a run does not know is told once)
(expect: warning K5577 at 8:6)
(expect: warning K5577 at 10:6)
(expect: path X10)
G10L52
N5042R1
N5042R2
N1320P1R500000
G11
G00X10.
M30
%
