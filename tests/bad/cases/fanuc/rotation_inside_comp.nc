%
O0001
T1 M6
S500 M3
G41 D1 G01 X10. Y0 F100.
X20.
G68 X0 Y0 R30.
X30.
G40 X50.
M30
%
(expect: 7:1 K5351 `G68` stands inside cutter radius compensation)
(exit: 3)
