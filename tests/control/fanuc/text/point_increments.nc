%
O0001
(rule: F 2.3 positions in increments, as older programs have them: no word about it)
(expect: path X50 x10y20f200)
(expect: warning K5241 at 7:1)
G54T1M06
M59
S100M03
G00X50000
G01X10000Y20000F200
M30
%
