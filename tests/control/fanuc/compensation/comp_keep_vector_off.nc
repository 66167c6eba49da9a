%
O0001
(rule: F 4.3 G38 has a vector to keep in the mode only)
(expect: to X0 Y-20)
(expect: alarm  K5285 at 10:1)
G10L12P1R5.
G17G90G40
M3S1000
G00X0.Y-20.
G38G01X10.F200.
M30
%
