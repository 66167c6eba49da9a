%
O0001
(rule: F 2.4 M00 stops, M01 with the switch; modal state is kept; M02 ends)
(expect: stop)
(expect: to X1 line F100)
(expect: to X2 line F100)
(expect: to X3 line F100)
G01F100M3S500
X1.
M00
X2.
M01
X3.
M02
X9.
%
