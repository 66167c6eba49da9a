%
O0001
(rule: F 3.4 G10 with values that are computed, in a loop over the offsets)
(expect: to X20)
(expect: to X30)
#1=1
WHILE[#1LE6]DO1
G10L2P#1X[#1*10]
#1=#1+1
END1
G55G00X0.
G56X0.
M30
%
