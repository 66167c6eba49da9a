%
O0001
(rule: F 3.3, 4.3: G28 inside G41: the vector is taken back over the place between, and it comes again behind)
(expect: path Y-20Z10 x-5y0f100 y35 X40Y30Z20 X0Y0Z0 x15 y35 x50y30)
G10L12P1R5.
T1M6S500M3
G00X0Y-20.Z10.
G41D1G01X0Y0F100
Y30.
G28X40.Y30.Z20.
G01X20.Y0
Y30.
G40X50.
M30
%
