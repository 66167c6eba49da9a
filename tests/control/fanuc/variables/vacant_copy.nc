%
O0001
(rule: F 6.3 a copy of vacant is vacant, + 0 makes 0)
(expect: #2 vacant)
(expect: #3 vacant)
(expect: #4=0)
(expect: #5=0)
(expect: #6=0)
(expect: #7=0)
#2=#0
#3=#2
#4=#2+0
#5=-#2
#6=#2*5
#7=#2+#2
M30
%
