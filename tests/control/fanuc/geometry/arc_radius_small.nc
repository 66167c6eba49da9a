%
O0001
(rule: F 3.5 a radius below half of the chord: PS0020)
(expect: alarm PS0020 K5221 at 5:10)
G02X20.Y0R5.F100
M30
%
