%
O0001
(rule: F 3.6 no polar words beside G53; G52 is no place)
(expect: to X30 Y0)
(expect: to X35 Y5)
G17G90G16
G00X30.Y0.
G15
G52X5.Y5.
X30.Y0
M30
%
