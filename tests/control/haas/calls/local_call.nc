%
O00001
(rule: Haas M97 P L: a local subprogram, from block N of this program to M99, L times)
(expect: to X10.)
(expect: to X20.)
(expect: to X30.)
(expect: to X0)
G00 X10.
M97 P1000 L2
X0
M30
N1000 G91 X10.
G90
M99
%
