%
O0001
(rule: F 3.1 G20: positions in inches)
(expect: #1=1)
(expect: #2=50.8)
G20X1.
#1=#5001
G21X50.8
#2=#5001
M30
%
