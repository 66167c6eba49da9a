%
O0001
(rule: F 6.4 X-#1 is X[-#1])
(expect: to X3 Y2)
#1=-3
G00X-#1Y-[#1+1]
M30
%
