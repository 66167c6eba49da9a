%
O0001
(rule: F 2.2 G22 and G23 are the machine's, and told once)
(expect: warning K5345 at 9:1)
(expect: warning K5345 at 10:1)
(expect: warning K5345 at 14:1)
(expect: to X5)
(expect: #1=23)
G22
G23
G22
G23
#1=#4004
G22X100.Y100.Z100.I-100.J-100.K-100.
G00X5.
M30
%
