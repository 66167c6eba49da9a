%
O0001
(rule: F 6.8 more than 5 macros)
(expect: alarm PS0122 K5462 at 11:1)
(expect: called 11:1 11:1 11:1 11:1 7:1)
(expect: #100=5)
G65P2
M30
O0002
#100=#100+1
G65P2
M99
%
