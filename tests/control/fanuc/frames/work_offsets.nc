%
O0001
(rule: F 3.4 G54 to G59 and G54.1 P; axis words of the block use it already)
(expect: #1=3)
(expect: #2=0)
(expect: to X-9)
(expect: to X-19)
(expect: to X-18)
(expect: to X1)
G10L2P2X-10.
G10L20P3X-20.
G55X1.
G54.1P3X1.
#1=#4130
G54P3X2.
G54X1.
#2=#4130
M30
%
