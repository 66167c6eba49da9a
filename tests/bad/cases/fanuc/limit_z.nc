%
O0001
G00 Z-9999.
M30
%
(expect: 3:5 OT0500 SOFT OVERTRAVEL: axis Z would go to -9999, its limit is -1000)
(exit: 3)
