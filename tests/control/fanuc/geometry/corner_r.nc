%
O0001
(rule: F 3.8 R is tangent to both sides; variables)
(expect: to X0 Y0)
(expect: to X35 Y0)
(expect: to X40 Y5 ccw I35 J5)
(expect: to X40 Y30)
#1=5
S1000M03
G90G00X0Y0
G01X40.,R#1F200.
Y30.
M30
%
