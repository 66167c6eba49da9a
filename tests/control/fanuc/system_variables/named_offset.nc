%
O0001
(rule: F 6.6 [#_WZG54[n]], [#_WZCMN[n]], [#_WZP1[n]] are 5220+n, 5200+n, 7000+n)
(expect: to X4 Y2)
(expect: to X6)
(expect: #1=4)
(expect: #2=6)
[#_WZG54[1]]=4
[#_WZCMN[2]]=2
G54G00X0.Y0.
[#_WZP1[1]]=6
G54.1P1X0.
#1=#5221
#2=#7001
M30
%
