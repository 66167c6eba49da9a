%
O0001
(rule: F 3.6 G91 radius: the pole is where the tool is)
(expect: to X10 Y10)
(expect: to X10 Y30)
(expect: to X-10 Y10)
G17G90G00X10.Y10.
G16
G91X20.Y45.
G90Y180.
G15
M30
%
