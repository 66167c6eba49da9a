%
O0001
(rule: case 10: a probing motion to a place of the machine goes by distances, another one is passed over)
(expect: warning K5233 at 7:1)
(expect: warning K5951 at 8:4)
G94G91
G53X5.
G53G31P2Z-1.F100
M30
%
