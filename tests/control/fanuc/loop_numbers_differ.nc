%
O0001
(rule: F 11 PS0126: the numbers of DO and END do not match)
(expect: alarm PS0124 K5434 at 5:1)
DO1
END2
M30
%
