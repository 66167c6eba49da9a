%
O0001
G99 G97 T0101 M03 S500
G00 X30. Z2.
G71 U2. R0.5 Z-20.
M30
%
(args: run {file} -d fanuc-lathe -m lathe --commands {out})
(expect: 5:1 PS0066 UNAVAILABLE COMMAND IS IN THE MULTIPLE REPETITIVE CYCLES BLOCK: the line gives words of `stock_rough`, and words of a motion that it does not have)
(exit: 3)
