%
O0001
(rule: F 4.3 G41 and no D anywhere: the radius is 0; H beside it is meant by No.5001#2)
(expect: warning K5901 at 9:4)
(expect: warning K5901 at 12:1)
(expect: fix `D19` calls the radius; `H` does where No.5001#2 is set)
(expect: path x10y5f100 x30 y0 x0)
T1M06S100M03
G01G41X10.Y5.F100
X30.
G40Y0
G42X0H19
M30
%
