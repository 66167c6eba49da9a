%
O0001
(rule: F 6.7 the same number again, one after the other)
(expect: #1=4)
#1=0
WHILE[#1LT2]DO1
#1=#1+1
END1
WHILE[#1LT4]DO1
#1=#1+1
END1
M30
%
