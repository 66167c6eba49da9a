%
O0001
(rule: F 6.7 DO without a condition, cut off)
(expect: alarm  K5439 at 7:1)
DO1
#1=#1+1
END1
M30
%
