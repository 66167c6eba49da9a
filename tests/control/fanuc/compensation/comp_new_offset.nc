%
O0001
(rule: F 4.3 a new D in the mode: the vector changes over the block)
(expect: to X0 Y0)
(expect: to X-5 Y20)
(expect: to X-5 Y50)
(expect: to X-8 Y80)
(expect: to X-8 Y90)
(expect: to X0 Y120)
M3S1000
G10L12P1R5.
G10L12P2R8.
G00X0Y0
G41D1G01X0Y20.F100
Y50.
D2Y80.
Y90.
G40X0Y120.
M30
%
