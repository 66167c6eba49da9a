%
O0001
G96 M03
G95 G01 X10. F0.1
M30
%
(expect: 3:1 PS1541 S-CODE ZERO: no cutting speed is set)
(exit: 3)
