%
O0001
(rule: F 6.5 #7021, #14022 and #101051 are the same additional offsets)
(expect: to X5 Y6)
(expect: #1=5)
(expect: #2=6)
#7021=5
#14022=6
G54.1P2G00X0.Y0.
#1=#101051
#2=#7022
M30
%
