%
O0001
(rule: F 3.6 G16: radius and angle; vector of 12)
(expect: to X43.3013 Y25)
(expect: to X0 Y50)
(expect: to X-50 Y0)
(expect: to X10 Y20)
G17G90G16
G00X50.Y30.
Y90.
G91Y90.
G90G15
X10.Y20.
M30
%
