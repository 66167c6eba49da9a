%
O0001
(rule: F 4.3 G39 at a corner that closes would cut: PS0041)
(expect: to X0 Y-20)
(expect: alarm PS0041 K5277 at 13:1)
G10L12P1R5.
G17G90G40
M3S1000
G00X0.Y-20.
G41D1G01X0.Y0.F200.
X40.
G39
Y40.
G40X80.Y0.
M30
%
