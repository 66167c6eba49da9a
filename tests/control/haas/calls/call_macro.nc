%
O00001
(rule: Haas G65 P with arguments: #24 is X, #18 is R; local variables of its own)
(expect: #100=12.5)
(expect: #101=7)
(expect: to X5.)
#1=7
G65 P30 X5. R7.5
#101=#1
M30
O00030
#100=#24+#18
G00 X#24
M99
%
