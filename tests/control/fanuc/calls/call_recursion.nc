%
O0001
(rule: F 6.8 a macro may call itself)
(expect: #100=24)
#100=1
G65P2A4.
M30
O0002
IF[#1LE1]GOTO9
#100=#100*#1
G65P2A[#1-1]
N9M99
%
