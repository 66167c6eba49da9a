%
O0001
(rule: F 4.3 outer corner up to 90 degrees of turn: where the offset lines meet)
(expect: to X0 Y0)
(expect: to X-5 Y20)
(expect: to X-5 Y52.07107)
(expect: to X46.46447 Y103.53553)
(expect: to X50 Y150)
M3S1000
G10L12P1R5.
G00X0Y0
G41D1G01X0Y20.F100
Y50.
X50.Y100.
G40X50.Y150.
M30
%
