%
O0001
(rule: F 2.5 the number of F stays when the mode changes)
(expect: #1=200)
(expect: to X1 F200)
(expect: to X2 F200)
M3S1000
G01G94F200X1.
G95X2.
#1=#4109
M30
%
