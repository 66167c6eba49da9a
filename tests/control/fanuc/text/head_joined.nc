%
O0001G20G90
(rule: F 1.2 blanks count nowhere: words may begin right behind the number of a program)
(expect: to X25.4 Y0)
(expect: to X50.8 Y0)
G00X1.Y0
M98P0002
M30
O0002G91
G00X1.
M99
%
