%
O0001
(rule: F 6.8 M99 in the main program begins it again)
(expect: #100=3)
#100=#100+1
IF[#100EQ3]GOTO9
M99
N9M30
%
