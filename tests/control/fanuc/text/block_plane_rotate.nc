%
O0001
(rule: F 3.7 G17 G68 X Y R in one block)
(expect: to X0 Y10)
G17G68X0Y0R90.
G69G00X0Y10.
M30
%
