%
O0001
(rule: F 6.8 No.6050: a G code calls O9010 as G65 does)
(expect: #100=5)
(expect: #101 vacant)
#1=7
G100A5.
#102=#1
M30
O9010
#100=#1
#101=#2
M99
%
