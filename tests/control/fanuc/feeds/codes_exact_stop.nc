%
O0001
(rule: F 3.2 G09 is for one block, G61 until G64; F 2.2 group 15)
(expect: #1=61)
(expect: #2=64)
(expect: to X1 line)
(expect: to X2 line)
(expect: to X3 line)
M3S500G1F100
G09X1.
G61X2.
#1=#4015
G64X3.
#2=#4015
M30
%
