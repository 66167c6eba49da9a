%
O0001
(rule: F 2.3 a position without a point is a thousandth of what it looks like: told among others with one)
(expect: warning K5902 at 9:4)
(expect: fix `X118.` has its point)
(expect: path X86Z0.25 x0.118f200 z-5 x0)
T1M06S100M03
G00X86.Z0.25
G01X118F200
Z-5.
X0
M30
%
