%
O0001
(rule: F 6.5 #3007: a bit for each mirrored axis)
(expect: #1=0)
(expect: #2=1)
(expect: #3=3)
(expect: #4=0)
#1=#3007
G51.1X0.
#2=#3007
G51.1Y0.
#3=#3007
G50.1X0.Y0.
#4=#3007
M30
%
