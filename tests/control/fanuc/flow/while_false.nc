%
O0001
(rule: F 6.7 tested at the top)
(expect: #100=5)
#100=5
WHILE[#100LE3]DO1
#100=#100+1
END1
M30
%
