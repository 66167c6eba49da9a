%
O0001
(rule: F 6.8 /M99: the operator ends the loop)
(expect: #100=1)
(skip: 1)
#100=#100+1
/M99
M30
%
