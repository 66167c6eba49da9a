%
O0001
(rule: F 3.6 G53 beside G31: a probing motion to a place of the machine, at its feed)
(expect: #1=-10)
(expect: #2=-13)
(expect: path X5 X6Z-13)
G90G54G94
S100M03
G00X5.
G90G53G31Z-10.F100
#1=#5063
#6=3.
G91G53G31P2Z-#6
#2=#5063
G90G00X6.
M30
%
