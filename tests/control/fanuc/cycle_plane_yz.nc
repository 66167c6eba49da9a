%
O0001
(rule: F 5.1 strokes along X in G19)
(expect: path X20 Y5Z6 X3 x-1 X3 X0 x-5 X3 X-4 x-7 X20)
G19G00X20.Y0Z0S1000M3
G83Y5.Z6.X-7.R3.Q4.F100
G80
M30
%
