%
O0001
(rule: F 6.5 #3003, #3004: 0 at power-on; #3004 from 0 to 7)
(expect: #1=0)
(expect: #2=0)
(expect: #3003=1)
(expect: #3=5)
(expect: to X1)
#1=#3003
#2=#3004
#3003=1
#3004=5
#3=#3004
G00X1.
M30
%
