%
O0001
(rule: F 3.6 G12.1: G41 and G42 act in the plane of X and C, G40 before G13.1)
(machine: driven)
(expect: to X40 C0 rapid)
(expect: to X25 Y0 C0)
(expect: to X25 Y25 C45)
(expect: to X-45 Y25 C150.945396)
(expect: to X-40 Y0 C180)
(expect: to X50 C180 rapid)
G10 P10002 R5. Q0
G98 G97 S1000 M3
T0202
G00 X80. Z2. C0
G112
G42 G01 X40. F200
C20.
X-80.
G40 C0
G113
G00 X100. C180.
M30
%
