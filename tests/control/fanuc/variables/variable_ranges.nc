%
O0001
(rule: F 6.2 locals, commons, permanent commons)
(expect: #1=1)
(expect: #33=2)
(expect: #100=3)
(expect: #199=4)
(expect: #500=5)
(expect: #999=6)
(expect: #98000=7)
#1=1
#33=2
#100=3
#199=4
#500=5
#999=6
#98000=7
M30
%
