%
O0001
(rule: F 3.7 G51 with I J K; below 0 mirrors)
(expect: to X-10 Y20)
(expect: to X1 Y1)
G51X0Y0Z0I-1000J2000K1000
X10.Y10.
G50
X1.Y1.
M30
%
