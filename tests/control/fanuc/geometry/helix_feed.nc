%
O0001
(rule: F 3.5 helix, No.1403#5 HTG = 0: F is the speed along the arc)
(expect: to Z0)
(expect: to Z-20 ccw I5 F118.544706)
(expect: to Z-20 ccw I5 F100)
(expect: to X10 Z-20 F100)
N1 S1000 M03
G90 G17 G00 X0. Y0. Z0.
G03 X0. Y0. I5. Z-20. F100.
X0. Y0. I5.
G01 X10.
M30
%
