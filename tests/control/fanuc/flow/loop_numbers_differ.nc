%
O0001
(rule: F 11 PS0126: the numbers of DO and END do not match)
(expect: alarm PS0124 K5434 at 6:1)
(expect: called 7:1)
DO1
END2
M30
%
