%
O0001
(rule: F 4.1 memory C: the radius that acts is geometry and wear; L13 is its wear)
(expect: to X-10 Y0)
(expect: to X0 Y3.5)
(expect: to X20 Y3.5)
(expect: to X30 Y0)
G10L12P5R4.
G10L13P5R-.5
G00X-10.Y0.
G17G90G01G41D5X0.Y0.F100
X20.
G40X30.
M30
%
