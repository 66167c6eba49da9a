%
O0001
(rule: F 3.1, 2.3 T-A: X with W, U with Z in a block)
(expect: to X20 Z0)
(expect: to X15 Z-5)
(expect: to X10 Z-20)
G00X40.Z0
X30.W-5.
U-10.Z-20.
M30
%
