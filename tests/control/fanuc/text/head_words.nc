%
O0001 (PLATE) G20 G90
(rule: F 1.2 the program number is a word of its block, and what stands behind it is read)
(expect: to X25.4 Y0)
(expect: to X50.8 Y0)
G00X1.Y0
M98P0002
M30
O0002 G91
G00X1.
M99
%
