%
O0001
(rule: F 11 PS0039: no corner in the block that begins the compensation)
(expect: alarm PS0039 K5531 at 7:15)
G10L12P1R5.
M3S100
G41D1G01X0Y20.,C2.F100
X20.
M30
%
