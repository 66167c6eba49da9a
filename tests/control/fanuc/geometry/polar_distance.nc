%
O0001
(rule: F 3.6 G16 under G91: both count on)
(expect: to X43.30127 Y25)
(expect: to X0 Y0)
G16G90X50.Y30.
G15G90X0Y0
M30
%
