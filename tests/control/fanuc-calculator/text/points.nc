%
O0001
(rule: F 2.3 No.3401#0 DPI = 1: a number without a point is in millimetres)
(expect: #1=10)
(expect: path X50 x10y20f200 x10.5)
(expect: dwell 2)
G54
G00X50
G01X10Y20F200
X10.5
#1=#5001-0.5
G04X2
M30
%
