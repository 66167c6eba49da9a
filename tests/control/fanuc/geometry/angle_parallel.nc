%
O0001
(rule: F 11 PS0057: both lines have one direction)
(expect: alarm PS0057 K5321 at 6:9)
G01,A45.F100
X10.Y20.,A45.
M30
%
