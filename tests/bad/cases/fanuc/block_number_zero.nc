%
O0001
N0 G0 X0. Y0.
M30
%
(expect: 3:1 K5021 `N0` is no number of a block)
(exit: 3)
