%
O0001
(rule: F 2.3 no position has a point: a path within 0.05 mm)
(expect: warning K5903 at 8:4)
(expect: fix `-d fanuc-calculator` reads a number without a point in millimetres)
(expect: path X0.05 x0.01y0.02f200)
T1M06S100M03
G00X50
G01X10Y20F200
M30
%
