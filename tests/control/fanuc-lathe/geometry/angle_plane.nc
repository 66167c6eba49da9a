%
O0001
(rule: F 3.8 only in G18: PS0212)
(expect: alarm PS0212 K5326 at 6:8)
G17G00X20.Y0
G01X40.,A45.F0.2
M30
%
