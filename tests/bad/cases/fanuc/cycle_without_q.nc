%
O0001
T1 M6
S500 M3
G00 X0. Y0. Z50.
G76 Z-10. R2. F100.
G80
M30
%
(G83 without Q drills in one stroke; a G76 without a shift scratches the wall.)
(expect: 6:1 K5253 without a lift the edge scratches the wall)
(exit: 3)
