%
O0001
(rule: F 1.2 : is O)
(expect: #1=1)
(expect: #2=8)
#1=#4115
M98P8
M30
:0008
#2=#4115
M99
%
