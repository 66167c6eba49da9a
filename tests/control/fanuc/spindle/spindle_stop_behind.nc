%
O0001
(rule: F 1.3 M05 and M09 act behind the motion of their block)
(expect: to X1 line)
G01F100M3S500
X1.M05
M30
%
