%
O0001
(rule: F 3.6 G33 Z F Q: Q in thousandths of a degree)
(expect: path t2@90:z-10)
M3S500
G33Z-10.F2.Q90000
M30
%
