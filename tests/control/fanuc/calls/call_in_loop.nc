%
O0001
(rule: F 6.8 a call in a loop)
(expect: #100=60)
WHILE[#1LT20]DO1
#1=#1+1
G65P2A3.
END1
M30
O0002
#100=#100+#1
M99
%
