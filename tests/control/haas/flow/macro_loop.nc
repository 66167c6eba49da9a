%
O00001
(rule: Haas WHILE and END: three numbers of loops)
(expect: #100=3)
(expect: to X1)
(expect: to X2)
(expect: to X3)
#100=0
WHILE [#100 LT 3] DO1
#100=#100+1
G00 X#100
END1
M30
%
