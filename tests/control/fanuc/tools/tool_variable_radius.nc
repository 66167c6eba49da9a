%
O0001
(rule: F 6.5 memory C: 13000+N radius, 12000+N its wear)
(expect: to X-10 Y0)
(expect: to X0 Y6.5)
(expect: to X9 Y6.5)
(expect: to X30 Y0)
(expect: #1=6)
(expect: #2=0.5)
#13008=6
#12008=.5
G00X-10.Y0.
G17G90G01G41D8X0.Y0.F100
X9.
G40X30.
#1=#13008
#2=#12008
M30
%
