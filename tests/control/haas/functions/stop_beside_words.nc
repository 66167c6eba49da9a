%
O00001
(rule: Haas M00 beside words stops behind the motion; a speed may have its point)
(expect: #1=5000)
(expect: path X10)
(expect: stop)
S5000. M03
#1=#4119
G00 X10. M00
M30
%
