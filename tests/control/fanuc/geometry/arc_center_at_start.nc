%
O0001
(rule: F 3.5: I and J are said, and the radius at the start is 0, at the end 10: PS0020)
(expect: alarm PS0020 K5220 at 6:9)
S100M3
G2X10.Y0I0J0F100
M30
%
