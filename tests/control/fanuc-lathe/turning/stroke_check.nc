%
O0001
(rule: F 2.3 G22 and G23 are the machine's, of group 09 here)
(expect: warning K5345 at 9:1)
(expect: warning K5345 at 10:1)
(expect: warning K5345 at 11:1)
(expect: #1=22)
(expect: #2=69)
G22
G23
G22X100.Z100.I-100.K-100.
#1=#4009
#2=#4004
M30
%
