%
O0001
(rule: F 4.8 G41 and cycles work in the plane; PS5457: not where it begins)
(machine: five-axis)
(expect: alarm PS5457 K5659 at 10:1)
T1M06
S1000M03
G41D1G01X10.F100.
X20.
G68.2X0Y0Z0I0J30.K0
M30
%
