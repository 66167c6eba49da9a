%
O0001
(rule: F 3.4 G10 P10000+n: geometry of offset n; X a diameter)
(expect: #1=-120.5)
(expect: #2=-80)
(expect: #3=0.8)
(expect: #4=3)
G10P10003X-120.5Z-80.R0.8Q3
#1=#2703
#2=#2803
#3=#2903
#4=#2303
M30
%
