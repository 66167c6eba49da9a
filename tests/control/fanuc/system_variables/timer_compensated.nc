%
O0001
(rule: F 6.5 #3001 counts blocks that wait for their corner: 10 mm to the contour, 60 mm along it)
(expect: #101=7000)
(expect: #102=7000)
G10L12P1R5.
G17G90G40
M3S1000
G00X-10.Y5.
#3001=0
G01F600.G41D1X0.Y0.
X60.
#101=#3001
#102=#3001
Y30.
G40X0.
M30
%
