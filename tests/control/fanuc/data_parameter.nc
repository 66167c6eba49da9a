%
O0001
(rule: F 3.4 G10 L52 writes parameters; there are none here)
(expect: alarm  K5018 at 5:1)
G10L52
N5042R1
G11
M30
%
