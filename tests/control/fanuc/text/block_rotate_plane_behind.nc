%
O0001
(rule: F 1.3 the plane of the block, wherever it stands in it)
(expect: to Z-10)
G68Z0X0R90.G18
G90G00X10.Z0
G69
M30
%
