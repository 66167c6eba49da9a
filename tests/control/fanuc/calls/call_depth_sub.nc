%
O0001
(rule: F 6.8 more than 10 subprograms)
(expect: alarm PS0077 K5461 at 11:1)
(expect: called 11:1 11:1 11:1 11:1 11:1 11:1 11:1 11:1 11:1 7:1)
(expect: #100=10)
M98P2
M30
O0002
#100=#100+1
M98P2
M99
%
