%
O0001
(rule: F 3.4 G10 P0: shift of the work system; 6.5 #2501)
(expect: #1=-4)
(expect: to X8 Z-3)
G10P0X-4.Z-5.
#1=#2501
S500M03
G00X20.Z2.
M30
%
